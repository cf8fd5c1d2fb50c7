// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/statistics.hpp"

#include <atomic>
#include <string>

namespace netloft::io {

/// Standard error as a place for people: whether it takes colour, and a line of progress.
class Terminal {
 public:
  /// `color`: auto, always or never. Auto wants a terminal that is not dumb, and no NO_COLOR.
  explicit Terminal(const std::string& color);
  ~Terminal() { clear(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  bool color() const { return color_; }
  void say(const std::string& text);

  /// A redrawn line on a terminal; in a pipe a line of key=value every five seconds. Silent for the first
  /// second.
  void progress(const IterationRecord& record, double tolerance);
  /// The same for a motion that has come to t [s] of `end`.
  void progress_in_time(double t, double end, double seconds);
  void clear();

 private:
  bool is_due(double now);
  bool is_terminal_, color_, drawn_ = false;
  double begun_, last_ = 0;
};

/// Set by the first SIGINT, SIGTERM, SIGHUP or SIGQUIT; a second one ends the program at once.
const std::atomic<bool>& interrupt_flag();
void catch_interrupts();

}  // namespace netloft::io
