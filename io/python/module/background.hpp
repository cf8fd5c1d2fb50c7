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

/// The end of a call whose work may still go on.
struct EndOfWork {
  std::exception_ptr raised;     // the exception of a signal handler; nullptr if there was none
  std::function<void()> finish;  // waits for work that still goes on; empty: it has ended
};

/// Like call_in_background(), but after a signal it waits only for a moment, and leaves unfinished work to
/// its thread. Therefore `work` has to own all that it uses. Exceptions of interrupted work are dropped.
EndOfWork call_or_leave(const std::function<void(std::atomic<bool>& interrupt)>& work);

/// Waits for all work that was left to its thread. It must be called before the interpreter ends.
void finish_left_work();

/// Like call_in_background(), for work with a result; throws the exception of the handler.
template <class Result>
Result in_background(const std::function<Result(const std::atomic<bool>&)>& work) {
  std::optional<Result> result;
  const auto raised = call_in_background([&](std::atomic<bool>& flag) { result.emplace(work(flag)); });
  if (raised) std::rethrow_exception(raised);
  return std::move(*result);
}

}  // namespace netloft::python
