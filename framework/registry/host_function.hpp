// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include "framework/registry/plugin_call.hpp"

#include <exception>

namespace netloft {

/// A C function that a plugin calls. It forwards to a member function of the object to which `host` points.
/// If an exception is thrown, it passes the message to Host::keep_message(), if this function exists, and
/// returns NETLOFT_ERROR.
template <auto Member>
struct HostFunction;

template <class Host, class Result, class... Args, Result (Host::*Member)(Args...)>
struct HostFunction<Member> {
  static Result call(void* host, Args... args) noexcept {
    const HostCall back;
    Host& object = *static_cast<Host*>(host);
    try {
      return (object.*Member)(args...);
    } catch (const std::exception& e) {
      keep(object, e.what());
    } catch (...) {
      keep(object, "an exception without a sentence");
    }
    return static_cast<Result>(NETLOFT_ERROR);
  }

 private:
  static void keep(Host& object, const char* sentence) {
    if constexpr (requires { object.keep_message(sentence); }) object.keep_message(sentence);
  }
};

}  // namespace netloft
