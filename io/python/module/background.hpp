// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pybind11/pybind11.h>

#include <atomic>
#include <exception>
#include <functional>
#include <optional>
#include <utility>

namespace netloft::python {

/// Calls `work` in another thread, without the interpreter lock, and waits for it. Meanwhile, Python handles
/// signals such as Ctrl-C. If a handler raises an exception, the flag that `work` receives becomes true.
/// Rethrows exceptions of `work`. Returns the exception of the handler; nullptr if there was none.
std::exception_ptr call_in_background(const std::function<void(std::atomic<bool>& interrupt)>& work);

/// The same for work with a result, but throws the exception of the handler.
template <class Result>
Result in_background(const std::function<Result(const std::atomic<bool>&)>& work) {
  std::optional<Result> result;
  const auto raised = call_in_background([&](std::atomic<bool>& flag) { result.emplace(work(flag)); });
  if (raised) std::rethrow_exception(raised);
  return std::move(*result);
}

}  // namespace netloft::python
