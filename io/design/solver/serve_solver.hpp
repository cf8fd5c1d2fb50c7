// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/solver/line_pipe.hpp"
#include "io/design/solver/solver_call.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>

namespace netloft::design {

/// The other end of a SolverProcess: answers the calls that arrive on standard input. A thread of its own
/// hears interruptions, and ends this process when the session ends. Answers go to standard output, while
/// what plugins print there goes to standard error.
class ServedSolver {
 public:
  /// `end_process` ends this process at once.
  explicit ServedSolver(std::function<void()> end_process);

  /// Answers calls for ever.
  [[noreturn]] void serve(const SolverCall& solver);
  /// Tells the session why this process ends now. For any thread.
  void say_end(const std::string& sentence);

 private:
  void hear();
  void take(const Json& message);
  Json next_call();
  void send(const Json& message);

  std::function<void()> end_process_;
  LinePipe pipe_;
  std::mutex sending_, hearing_;
  std::condition_variable heard_;
  std::deque<Json> calls_;
  std::uint64_t last_call_ = 0;
  std::atomic<bool> interrupt_{false};
};

}  // namespace netloft::design
