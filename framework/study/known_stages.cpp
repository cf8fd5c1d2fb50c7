// SPDX-License-Identifier: BSD-3-Clause
#include "framework/study/known_stages.hpp"

#include "framework/study/variants.hpp"

#include <algorithm>
#include <utility>

namespace netloft {

namespace {

bool ask_the_same(const StageRequest& a, const StageRequest& b) {
  return a.by == b.by && is_same(a.variant, b.variant) && a.tolerance == b.tolerance && a.path == b.path &&
         a.iterations == b.iterations && a.flags == b.flags && a.parameters == b.parameters &&
         a.start == b.start;
}

std::size_t numbers_of(const KnownStage& stage) {
  constexpr std::size_t kOfAPoint = sizeof(IterationRecord) / sizeof(double);
  const Solution& s = stage.solution;
  std::size_t sum = stage.asked.start.size() + kOfAPoint * s.run.history.size();
  for (const auto* v : {&s.u, &s.x, &s.residual, &s.x_low, &s.growing.mode, &s.growing.mode_later,
                        &s.correction.x, &s.correction.x_low})
    sum += v->size();
  return sum;
}

}  // namespace

const KnownStage* KnownStages::find(const StageRequest& request) const {
  const auto found = std::find_if(stages_.begin(), stages_.end(),
                                  [&](const KnownStage& s) { return ask_the_same(s.asked, request); });
  return found == stages_.end() ? nullptr : &*found;
}

void KnownStages::keep(KnownStage stage) {
  const auto forget = [&](std::list<KnownStage>::iterator one) {
    numbers_ -= numbers_of(*one);
    stages_.erase(one);
  };
  const auto before = std::find_if(stages_.begin(), stages_.end(),
                                   [&](const KnownStage& s) { return ask_the_same(s.asked, stage.asked); });
  if (before != stages_.end()) forget(before);
  numbers_ += numbers_of(stage);
  stages_.push_back(std::move(stage));
  while (numbers_ > most_) forget(stages_.begin());
}

}  // namespace netloft
