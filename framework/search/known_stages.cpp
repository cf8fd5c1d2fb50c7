// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/known_stages.hpp"

#include "framework/search/variants.hpp"

#include <algorithm>
#include <utility>

namespace netloft {

namespace {

bool are_same(const StageRequest& a, const StageRequest& b) {
  return a.by_strategy == b.by_strategy && a.by == b.by && is_same(a.variant, b.variant) &&
         a.tolerance == b.tolerance && a.path == b.path && a.iterations == b.iterations &&
         a.flags == b.flags && a.parameters == b.parameters && a.start == b.start;
}

std::size_t numbers_of(const KnownStage& stage) {
  const Solution& s = stage.solution;
  std::size_t sum = stage.request.start.size();
  for (const auto* v : {&s.u, &s.x, &s.residual, &s.x_low, &s.growing.mode, &s.growing.mode_later,
                        &s.correction.x, &s.correction.x_low})
    sum += v->size();
  return sum;
}

}  // namespace

const KnownStage* KnownStages::find(const StageRequest& request) {
  const auto found = std::find_if(stages_.begin(), stages_.end(),
                                  [&](const KnownStage& s) { return are_same(s.request, request); });
  if (found == stages_.end()) return nullptr;
  stages_.splice(stages_.end(), stages_, found);
  return &*found;
}

void KnownStages::keep(KnownStage stage) {
  const auto forget = [&](std::list<KnownStage>::iterator one) {
    numbers_ -= numbers_of(*one);
    stages_.erase(one);
  };
  const auto before = std::find_if(stages_.begin(), stages_.end(),
                                   [&](const KnownStage& s) { return are_same(s.request, stage.request); });
  if (before != stages_.end()) forget(before);
  stage.solution.cost = {};
  stage.solution.judging = {};
  stage.solution.run.history.clear();
  numbers_ += numbers_of(stage);
  stages_.push_back(std::move(stage));
  while (numbers_ > most_) forget(stages_.begin());
}

}  // namespace netloft
