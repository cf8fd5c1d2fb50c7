// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/cost.hpp"

#include <gtest/gtest.h>

namespace netloft {
namespace {

Cost cost_of(const std::string& stage, int iterations, double work) {
  Cost cost{.statistics = {.iterations = iterations}, .work = work, .stages = {}};
  cost.stages.push_back({.name = stage});
  return cost;
}

std::string names_of(const Cost& cost) {
  std::string names;
  for (const StageRecord& stage : cost.stages) names += stage.name + " ";
  return names;
}

TEST(Cost, ListsStagesInTheirOrderWhicheverIsAddedToWhich) {
  const Cost first = cost_of("first", 3, 1.5), second = cost_of("second", 4, 2.5);
  Cost later = first, earlier = second;
  later.add(second), earlier.add_before(first);
  for (const Cost& sum : {later, earlier}) {
    EXPECT_EQ(names_of(sum), "first second ");
    EXPECT_EQ(sum.statistics.iterations, 7);
    EXPECT_DOUBLE_EQ(sum.work, 4);
  }
}

}  // namespace
}  // namespace netloft
