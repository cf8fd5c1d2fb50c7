// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pybind11/pybind11.h>

#include <atomic>
#include <exception>
#include <functional>
#include <optional>
#include <utility>

namespace netloft::python {

/// Calls `work` in another thread, without the interpreter lock, and waits for it. Signals such as Ctrl-C are
/// handled meanwhile by Python; if a handler raises an exception, the flag that `work` receives becomes true.
/// Rethrows what `work` throws. Returns the exception of the handler; nullptr: there was none.
std::exception_ptr call_in_background(const std::function<void(std::atomic<bool>& interrupt)>& work);

/// The same for work with a result. Throws the exception of the handler.
template <class Result>
Result in_background(const std::function<Result(const std::atomic<bool>&)>& work) {
  std::optional<Result> result;
  const auto raised = call_in_background([&](std::atomic<bool>& flag) { result.emplace(work(flag)); });
  if (raised) std::rethrow_exception(raised);
  return std::move(*result);
}

}  // namespace netloft::python
