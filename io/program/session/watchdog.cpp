// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/watchdog.hpp"

#include "framework/balance/statistics.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/last_words.hpp"
#include "io/program/session/options.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/reading_progress.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <utility>

namespace netloft::program {

namespace {

constexpr double kLook = 0.1;  // [s] between two inspections
// Time that a call of a plugin may still take after the limit [s]; factorisations of the host do not count.
constexpr double kGrace = 2;
constexpr double kGraceOfReading = 0.5;  // time that reading a scene may still take [s]
// Processor time that writing a result may still take after an interruption [s]. The time until the solver
// notices the interruption does not count.
constexpr double kGraceOfWriting = 0.5;
// Number of calls of the host that a method may still make after the limit. Within this number of calls,
// built-in solvers check the time at least ten times.
constexpr std::uint64_t kCallbacks = 1000;
constexpr unsigned kLastAct = 10;  // [s] for writing the results
constexpr double kPark = 5;        // time for a thread to reach the boundary of plugins [s]

int exit_code(bool interrupted) { return interrupted ? kInterrupted : kNotConverged; }

/// Ends the program if the results are not written in time, because another call of a plugin never returns.
void give_up(int) {
  constexpr char words[] =
      "netloft: the results so far could not be written, because a plugin does not return\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words, sizeof words - 1);
  end_at_once(interrupt_flag() ? kInterrupted : kNotConverged);
}

void limit_last_act() {
  struct sigaction action {};
  action.sa_handler = give_up;
  sigaction(SIGALRM, &action, nullptr);
  alarm(kLastAct);
}

/// The innermost solver, integrator or strategy that has not returned since the watchdog began to watch.
CallFrame caller_for_ever(const CallStack& calls) {
  for (std::uint32_t i = std::min(calls.lowest(), CallStack::kDeepest); i-- > 0;)
    if (const CallFrame frame = calls.at(i); frame.kind == CallFrame::Kind::method) return frame;
  return {};
}

}  // namespace

Watchdog::Watchdog(Terminal& terminal, std::function<int(const Overdue&)> last_act,
                   const std::atomic<bool>& interrupt)
    : terminal_(terminal),
      last_act_(std::move(last_act)),
      interrupt_(interrupt),
      thread_([this] { watch(); }) {}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Watchdog::allow(double seconds) {
  const std::lock_guard lock(mutex_);
  deadline_ = cpu_seconds() + seconds;
}

void Watchdog::begin_writing(std::function<void()> abandon) {
  const std::lock_guard lock(mutex_);
  abandon_ = std::move(abandon);
  writing_since_cpu_ = cpu_seconds();
}

void Watchdog::end_writing() {
  const std::lock_guard lock(mutex_);  // not available while the watchdog abandons the result
  abandon_ = nullptr;
}

bool Watchdog::is_over(bool& interrupted) {
  interrupted = interrupt_;
  return interrupted || cpu_seconds() > deadline_;
}

void Watchdog::watch() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::duration<double>(kLook), [this] { return stop_; })) {
    bool interrupted = false;
    if (interrupt_) look_at_interruption(wall_seconds());
    if (is_over(interrupted))
      look(interrupted, wall_seconds());
    else
      seen_.clear();
  }
}

/// Ends a run if reading does not end after an interruption. Most steps of reading check for interruptions,
/// but some take long, such as a factorisation for the initial shape of a large gear.
void Watchdog::look_at_interruption(double now) {
  if (interrupted_at_ == 0) {
    interrupted_at_ = now;
    interrupted_at_cpu_ = cpu_seconds();
  }
  if (abandon_ && cpu_seconds() - std::max(interrupted_at_cpu_, writing_since_cpu_) > kGraceOfWriting)
    abandon_result();
  const std::string under_way = terminal_.reading().under_way();
  if (!under_way.empty() && now - interrupted_at_ > kGraceOfReading)
    end(true, under_way + " did not end after the interruption");
}

void Watchdog::abandon_result() {
  abandon_();
  const std::string said =
      "interrupted; the result is not written, because writing it took more than half a second of processor "
      "time";
  terminal_.say("netloft: " + said);
  if (terminal_.json()) print_line(error_json(said, kInterrupted));
  std::fflush(stdout);
  std::fflush(stderr);
  end_at_once(kInterrupted);
}

/// Compares the calls that all threads are in with their calls at the last inspection.
void Watchdog::look(bool interrupted, double now) {
  if (seen_.empty()) over_since_ = now;
  for (CallStack* calls : calls_of_all_threads()) {
    const auto known =
        std::find_if(seen_.begin(), seen_.end(), [&](const Seen& s) { return s.calls == calls; });
    if (known != seen_.end())
      look_at(*known, interrupted, now);
    else {
      calls->watch_depth();
      seen_.push_back({calls, calls->crossings(), calls->callbacks(), now});
    }
  }
}

void Watchdog::look_at(Seen& seen, bool interrupted, double now) {
  const CallStack& calls = *seen.calls;
  if (calls.crossings() != seen.crossings) {
    seen.crossings = calls.crossings();
    seen.since = now;
  }
  const CallFrame frame = calls.innermost();
  if (frame.kind != CallFrame::Kind::host && now - seen.since > kGrace) {
    stop_others_at_the_boundary();
    end(interrupted, frame, now - seen.since);
  }
  const CallFrame method = caller_for_ever(calls);
  if (!method.type || now - over_since_ <= kGrace ||
      calls.callbacks() - seen.callbacks_at_first <= kCallbacks)
    return;
  stop_others_at_the_boundary();
  for (double left = kPark; left > 0 && threads_at_the_boundary() == 0; left -= kLook)
    std::this_thread::sleep_for(std::chrono::duration<double>(kLook));
  end(interrupted, method, now - over_since_);
}

void Watchdog::end(bool interrupted, const CallFrame& frame, double waited) {
  end(interrupted,
      fmt::format("{}, did not return for {:.0f} s after {}", text_of(frame), waited,
                  interrupted ? "the interruption" : "the limit of processor time (analysis.max_seconds)"));
}

void Watchdog::end(bool interrupted, const std::string& sentence) {
  limit_last_act();
  int code = exit_code(interrupted);
  try {
    code = last_act_({interrupted, sentence});
  } catch (const std::exception& e) {
    print_error(std::string("netloft: the results so far could not be written: ") + e.what());
  }
  std::fflush(stdout);
  std::fflush(stderr);
  end_at_once(code);
}

std::function<int(const Overdue&)> ending_with_a_sentence(Terminal& terminal, std::string what_is_left) {
  return [&terminal, left = std::move(what_is_left)](const Overdue& overdue) {
    terminal.clear();
    const std::string said = overdue.sentence + "; " + left;
    const int code = exit_code(overdue.interrupted);
    terminal.say("netloft: " + said);
    if (terminal.json()) print_line(error_json(said, code));
    return code;
  };
}

}  // namespace netloft::program
