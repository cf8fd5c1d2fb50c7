// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/work/long_work.hpp"

#include <string>
#include <vector>

namespace netloft::test {

/// Records the steps of long work, and interrupts it at steps that deal with `last`.
class WorkNotes : public formats::WorkFollower {
 public:
  explicit WorkNotes(std::string last = "none")
      : last_(std::move(last)), before_(formats::follow_work(this)) {}
  ~WorkNotes() override { formats::follow_work(before_); }
  WorkNotes(const WorkNotes&) = delete;
  WorkNotes& operator=(const WorkNotes&) = delete;

  void at(const formats::Step& step) override {
    heard.push_back(std::string(step.deed) + " " + std::string(step.of));
    if (heard.back() == last_) throw formats::Interrupted{};
  }
  void hear() override { heard.emplace_back("…"); }
  void end() noexcept override { heard.emplace_back("end"); }

  std::vector<std::string> heard;

 private:
  std::string last_;
  formats::WorkFollower* before_;
};

}  // namespace netloft::test
