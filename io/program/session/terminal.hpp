// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/statistics.hpp"

#include <atomic>
#include <string>

namespace netloft::program {

/// Standard error as a place for people: whether it takes colour, and a line of progress.
class Terminal {
 public:
  /// `color`: auto, always or never. Auto wants a terminal that is not dumb, and no NO_COLOR.
  /// `json`: progress as JSON objects, one a line.
  explicit Terminal(const std::string& color, bool json = false);
  ~Terminal() { clear(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  bool color() const { return color_; }
  bool json() const { return json_; }
  void say(const std::string& text);

  /// A redrawn line on a terminal; in a log a line of key=value a minute, after the first second; for
  /// programs a JSON object a second. A stage of the solve ends where iterations are counted from the start
  /// again.
  void progress(const IterationRecord& record, double tolerance);
  /// The same for a motion that has come to t [s] of `end` after `seconds`, with the time that is left if the
  /// rest goes as fast. `run`: its name, if it is one of several.
  void progress_in_time(double t, double end, double seconds, const std::string& run = {});
  /// The same for work that consists of many solves: `done` of `all` (0: nobody knows how many) `things`
  /// ("items"); `last`: what the last one was.
  void progress_in_steps(const std::string& things, std::size_t done, std::size_t all,
                         const std::string& last);
  void clear();

 private:
  bool is_due(double now);
  void show(const std::string& bar, const std::string& pairs, const std::string& object);

  bool is_terminal_, color_, json_, drawn_ = false;
  double begun_, last_ = 0;
  int stage_ = 1, last_iteration_ = -1;
  double first_residual_ = 0, stage_begun_ = 0;
};

/// What an interruption does: Ctrl-C, a request to end, a quit, and a hangup unless `nohup` has it ignored.
void on_interrupts(void (*action)(int));

/// Until catch_interrupts() is called, an interruption ends the program with a sentence: a scene is being
/// read, and nothing has been found that could be lost.
void end_on_interrupts(bool json);

/// Set by the first SIGINT, SIGTERM, SIGHUP or SIGQUIT; a second one ends the program at once.
const std::atomic<bool>& interrupt_flag();
void catch_interrupts();

/// Says that the user interrupted, and what is left: "the table has 3 of 7 depths". Returns the exit code.
int end_interrupted(Terminal& terminal, const std::string& what_is_left);

}  // namespace netloft::program
