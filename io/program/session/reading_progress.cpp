// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/reading_progress.hpp"

#include "framework/balance/statistics.hpp"
#include "io/program/session/terminal.hpp"

#include <chrono>

namespace netloft::program {

ReadingProgress::ReadingProgress(Terminal& terminal)
    : terminal_(terminal), before_(formats::follow_work(this)) {}

ReadingProgress::~ReadingProgress() {
  formats::follow_work(before_);
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void ReadingProgress::at(const formats::Step& step) {
  {
    const std::lock_guard lock(mutex_);
    if (deed_.empty()) begun_ = wall_seconds();
    deed_ = step.deed;
    of_ = step.of;
    unit_ = step.unit;
    done_ = step.done;
  }
  if (!thread_.joinable()) thread_ = std::thread([this] { draw(); });
  hear();
}

void ReadingProgress::hear() {
  if (interrupt_flag()) throw formats::Interrupted{};
}

void ReadingProgress::end() noexcept {
  const std::lock_guard lock(mutex_);
  deed_.clear();
  terminal_.clear();
}

std::string ReadingProgress::under_way() const {
  const std::lock_guard lock(mutex_);
  return deed_.empty() || of_.empty() ? deed_ : deed_ + ' ' + of_;
}

void ReadingProgress::draw() {
  constexpr std::chrono::milliseconds kLook{100};
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, kLook, [this] { return is_over_; }))
    if (!deed_.empty()) terminal_.progress_in_reading({deed_, of_, done_, unit_}, wall_seconds() - begun_);
}

}  // namespace netloft::program
