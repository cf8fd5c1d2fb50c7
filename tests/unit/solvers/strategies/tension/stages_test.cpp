// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/stages.hpp"

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/strategies/tension/taken_as_members.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::tension {
namespace {

using StageEnding = MixedNewton::Ending;

/// Compares the equilibrium found by stages with the one found by newton from the sketch. Starting from the
/// equilibrium of the stages, newton must need few iterations.
void expect_same_place(const Scene& scene, double size) {
  TakenAsMembers taken(scene);
  EXPECT_EQ(Stages(defaults<FromSoft>(), taken.problem.interface()).solve(taken.u), StageEnding::converged);
  Scene there = scene;
  there.positions = taken.positions();
  const test::Solved confirmed = test::solve(there, {{}, {.tolerance = 1e-8}}), direct = test::solve(scene);
  EXPECT_LE(confirmed.solution.cost.statistics.iterations, 3);
  ASSERT_EQ(confirmed.solution.status, SolveStatus::converged) << confirmed.solution.reason;
  ASSERT_EQ(direct.solution.status, SolveStatus::converged) << direct.solution.reason;
  EXPECT_LT(test::largest_difference(direct.solution.x, confirmed.solution.x), 1e-6 * size);
}

TEST(TensionStages, LeadARopeToWhereItHangs) { expect_same_place(sample::hanging_rope(40), 100); }

TEST(TensionStages, LeadAPanelThatStartsSlackToWhereItHangs) {
  expect_same_place(sample::hanging_panel(8, 30), 48);
}

TEST(TensionStages, EndWhereTheHostGivesUp) {
  TakenAsMembers taken(sample::hanging_panel(8, 30), {.iterations = 4});
  EXPECT_EQ(Stages(defaults<FromSoft>(), taken.problem.interface()).solve(taken.u), StageEnding::called_off);
  EXPECT_EQ(taken.problem.statistics().iterations, 4);
  EXPECT_EQ(taken.problem.stop(), Stop::iterations);
}

}  // namespace
}  // namespace netloft::tension
