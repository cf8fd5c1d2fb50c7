// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/work/long_work.hpp"

#include <atomic>

namespace netloft::python {

/// Ends the reading of scenes in this thread when the flag is set.
class InterruptibleReading : public formats::WorkFollower {
 public:
  explicit InterruptibleReading(const std::atomic<bool>& interrupt)
      : interrupt_(interrupt), before_(formats::follow_work(this)) {}
  ~InterruptibleReading() override { formats::follow_work(before_); }
  InterruptibleReading(const InterruptibleReading&) = delete;
  InterruptibleReading& operator=(const InterruptibleReading&) = delete;

  void at(const formats::Step&) override { hear(); }
  void hear() override {
    if (interrupt_) throw formats::Interrupted();
  }
  void end() noexcept override {}

 private:
  const std::atomic<bool>& interrupt_;
  formats::WorkFollower* before_;
};

}  // namespace netloft::python
