// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <string>

namespace netloft::program {

/// What a command on studies answers, for people or for programs.
inline void print_answer(const Options& o, const nlohmann::ordered_json& json, const std::string& text) {
  using Json = nlohmann::ordered_json;
  std::puts(o.json ? json.dump(2, ' ', false, Json::error_handler_t::replace).c_str() : text.c_str());
}

/// "1 item", "2 items".
inline std::string count_of(std::size_t n, const char* what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

}  // namespace netloft::program
