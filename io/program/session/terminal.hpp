// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/statistics.hpp"
#include "io/program/session/options.hpp"

#include <atomic>
#include <string>

namespace netloft::program {

/// Standard error: messages, and a line of progress.
class Terminal {
 public:
  /// --color auto means colour on a terminal that is not dumb, unless NO_COLOR is set. With --json progress
  /// is JSON objects, one a line.
  explicit Terminal(const CommonOptions& options);
  ~Terminal() { clear(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  bool color() const { return color_; }
  bool json() const { return json_; }
  void say(const std::string& text);

  /// Shows the progress of a search after the first second: a redrawn line on a terminal, a line of key=value
  /// a minute in a log, a JSON object a second for programs. A new stage begins when iterations are counted
  /// from 0 again.
  void progress(const IterationRecord& record, double tolerance);
  /// The same for a motion at t [s] of `end` after `seconds` of wall time, with the time that is left at this
  /// speed. `run` is its name if it is one of several.
  void progress_in_time(double t, double end, double seconds, const std::string& run = {});
  /// The same for work in steps: `done` of `all` (0 if that is not known) `things` ("items"). `last` names
  /// the last one.
  void progress_in_steps(const std::string& things, std::size_t done, std::size_t all,
                         const std::string& last);
  /// The same for meshing, after two seconds: the panel or step under way, and the number of nodes so far.
  void progress_in_meshing(const std::string& step, std::size_t nodes);
  void clear();

 private:
  double pause() const;
  bool is_due(double now);
  void show(const std::string& bar, const std::string& pairs, const std::string& object);

  bool is_terminal_, color_, json_, drawn_ = false;
  double begun_, last_ = 0, last_of_meshing_ = 0;
  int stage_ = 1, last_iteration_ = -1;
  double first_residual_ = 0, stage_begun_ = 0;
};

/// Sets the action of interruptions: SIGINT, SIGTERM, SIGQUIT, and SIGHUP unless `nohup` has it ignored.
void on_interrupts(void (*action)(int));

/// Until catch_interrupts() is called, an interruption ends the program at once with a sentence, because
/// nothing has been found that could be lost.
void end_on_interrupts(bool json);

/// Set by the first SIGINT, SIGTERM, SIGHUP or SIGQUIT; a second one ends the program at once.
const std::atomic<bool>& interrupt_flag();
void catch_interrupts();

/// Reports an interruption and what there is so far, such as "the table has 3 of 7 depths". Returns the exit
/// code.
int end_interrupted(Terminal& terminal, const std::string& what_is_left);

}  // namespace netloft::program
