// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/work/long_work.hpp"

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace netloft::program {

class Terminal;

/// Shows the progress of reading and meshing scenes, and ends both by formats::Interrupted after an
/// interruption. A separate thread draws, because a single step may take long. It draws only during reading;
/// nothing else may write to the terminal during that time.
class ReadingProgress : public formats::WorkFollower {
 public:
  explicit ReadingProgress(Terminal& terminal);
  ~ReadingProgress() override;
  ReadingProgress(const ReadingProgress&) = delete;
  ReadingProgress& operator=(const ReadingProgress&) = delete;

  void at(const formats::Step& step) override;
  void hear() override;
  void end() noexcept override;

  /// The present step, such as "meshing belly"; empty if nothing is being read.
  std::string under_way() const;

 private:
  void draw();

  Terminal& terminal_;
  formats::WorkFollower* before_;
  mutable std::mutex mutex_;  // protects all members below and, during reading, the terminal
  std::condition_variable wake_;
  bool is_over_ = false;
  std::string deed_, of_, unit_;  // words for the step; deed_ is empty if nothing is being read
  std::size_t done_ = 0;
  double begun_ = 0;    // [s]
  std::thread thread_;  // started by the first step
};

}  // namespace netloft::program
