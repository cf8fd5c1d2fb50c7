// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/statistics.hpp"
#include "io/formats/toml/diagnostics.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/program/session/options.hpp"

#include <atomic>
#include <memory>
#include <string>

namespace netloft::program {

class ReadingProgress;

/// Standard error: messages and a progress line.
class Terminal {
 public:
  /// --color auto means colour on a terminal, unless TERM is "dumb" or NO_COLOR is set. With --json, progress
  /// is written as one JSON object per line.
  explicit Terminal(const CommonOptions& options);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  bool json() const { return json_; }
  void say(const std::string& text);
  /// Shows all messages, in colour if the terminal supports it.
  void say(const formats::Diagnostics& diagnostics);
  /// The progress of reading scenes, which is shown automatically while this object exists.
  const ReadingProgress& reading() const { return *reading_; }

  /// Shows the progress of a search after the first second: a line that is redrawn on a terminal, a line of
  /// key=value per minute in a log, a JSON object per second for programs. A new stage begins when the
  /// iteration number returns to 0.
  void progress(const IterationRecord& record, double tolerance);
  /// Shows the progress of a motion from 0 to `end` [s] that has reached the time `t` after `seconds` of wall
  /// time, and the remaining wall time at this rate. `run` is the name of the motion if there are several.
  void progress_in_time(double t, double end, double seconds, const std::string& run = {});
  /// Shows the progress of work in steps: `done` of `all` steps are done; `all` is 0 if their number is
  /// unknown. `things` is a word for the steps, such as "items"; `last` names the step that was done last.
  void progress_in_steps(const std::string& things, std::size_t done, std::size_t all,
                         const std::string& last);
  /// Shows the progress of reading a scene, which has taken `seconds` so far. Shows nothing in the first two
  /// seconds.
  void progress_in_reading(const formats::Step& step, double seconds);
  void clear();

 private:
  double pause() const;
  bool is_due(double now);
  void show(const std::string& bar, const std::string& pairs, const std::string& object);

  bool is_terminal_, color_, json_, drawn_ = false;
  double begun_, last_ = 0, last_of_reading_ = 0;
  int stage_ = 1, last_iteration_ = -1;
  double first_residual_ = 0, stage_begun_ = 0;
  std::unique_ptr<ReadingProgress> reading_;
};

/// Sets the handler of interruptions: SIGINT, SIGTERM, SIGQUIT, and SIGHUP, unless `nohup` has made the
/// program ignore it.
void on_interrupts(void (*action)(int));

/// From now on, until catch_interrupts() is called, an interruption ends the program at once with a sentence.
/// There are no results to lose yet.
void end_on_interrupts(bool json);

/// True after the first SIGINT, SIGTERM, SIGHUP or SIGQUIT. A second signal ends the program at once.
const std::atomic<bool>& interrupt_flag();
void catch_interrupts();

/// Reports an interruption and the results so far, such as "the table has 3 of 7 depths". Returns the exit
/// code.
int end_interrupted(Terminal& terminal, const std::string& what_is_left);

}  // namespace netloft::program
