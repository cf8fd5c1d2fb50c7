// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/work/long_work.hpp"

#include <atomic>

namespace netloft::formats {

/// Ends long work in this thread, such as the reading of a scene, when the flag is set.
class InterruptibleWork : public WorkFollower {
 public:
  explicit InterruptibleWork(const std::atomic<bool>& interrupt)
      : interrupt_(interrupt), before_(follow_work(this)) {}
  ~InterruptibleWork() override { follow_work(before_); }
  InterruptibleWork(const InterruptibleWork&) = delete;
  InterruptibleWork& operator=(const InterruptibleWork&) = delete;

  void at(const Step&) override { hear(); }
  void hear() override {
    if (interrupt_) throw Interrupted();
  }
  void end() noexcept override {}

 private:
  const std::atomic<bool>& interrupt_;
  WorkFollower* before_;
};

}  // namespace netloft::formats
