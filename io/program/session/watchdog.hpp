// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/plugin_call.hpp"
#include "io/program/session/terminal.hpp"

#include <condition_variable>
#include <functional>
#include <limits>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace netloft::program {

/// A plugin, or the reading of a scene, that continued after its time was over.
struct Overdue {
  bool interrupted = false;  // by the user; otherwise, the processor time of the analysis is used up
  std::string sentence;      // such as "loops/forever, solve, did not return for 2 s after Ctrl-C"
};

/// Ends a run that does not react to an interruption. Solvers check for interruptions and for the time limit
/// between steps, but a call of a plugin may never return. The watchdog runs in its own thread. It
/// calls `last_act`, which writes what was found so far, in three cases after an interruption or the limit:
///   the same call of a plugin has gone on for 2 s;
///   a solver, integrator or strategy has called the host 1000 times, and 2 s have passed;
///   a scene that was being read at the interruption is still being read half a second later.
/// All other threads then wait at the boundary of plugins or are inside a plugin, so that the host can write
/// its results. The program ends with the code that `last_act` returns; if it does not return, the program
/// ends after ten seconds.
class Watchdog {
 public:
  /// `interrupt`: the flag of interruptions; by default that of the program.
  Watchdog(Terminal& terminal, std::function<int(const Overdue&)> last_act,
           const std::atomic<bool>& interrupt = interrupt_flag());
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// Sets the processor time that is allowed from now on [s].
  void allow(double seconds);
  /// Announces that the result is written from now on. After an interruption, writing may take half a second
  /// of processor time; then the thread of the watchdog calls `abandon` and ends the program.
  void begin_writing(std::function<void()> abandon);
  /// Announces that the result is complete. From now on, an interruption can no longer prevent it from
  /// getting its final name.
  void end_writing();

 private:
  struct Seen {
    CallStack* calls;
    std::uint64_t crossings, callbacks_at_first;
    double since;
  };
  void watch();
  bool is_over(bool& interrupted);
  void look(bool interrupted, double now);
  void look_at_interruption(double now);
  [[noreturn]] void abandon_result();
  [[noreturn]] void end(bool interrupted, const CallFrame& frame, double waited);
  [[noreturn]] void end(bool interrupted, const std::string& sentence);
  void look_at(Seen& seen, bool interrupted, double now);

  Terminal& terminal_;
  std::function<int(const Overdue&)> last_act_;
  const std::atomic<bool>& interrupt_;
  double interrupted_at_ = 0, interrupted_at_cpu_ = 0;  // [s], of processor time; 0: not interrupted
  double writing_since_cpu_ = 0;                        // [s], of processor time
  std::function<void()> abandon_;                       // empty if no result is being written
  double deadline_ = std::numeric_limits<double>::infinity();
  double over_since_ = 0;
  std::vector<Seen> seen_;
  bool stop_ = false;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread thread_;
};

/// Makes a `last_act` that reports the plugin and a sentence `what_is_left`, such as "the comparison ends
/// here without a table". With --json, it also prints both as an object.
std::function<int(const Overdue&)> ending_with_a_sentence(Terminal& terminal, std::string what_is_left);

}  // namespace netloft::program
