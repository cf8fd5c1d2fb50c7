// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/known_answers.hpp"
#include "tests/verification/reference.hpp"
#include "tests/verification/scene_file.hpp"

namespace netloft::test {
namespace {

Values preconditioned_by(const std::string& word) { return {{"preconditioner", word}}; }

class LbfgsWith : public testing::TestWithParam<const char*> {};

TEST_P(LbfgsWith, PullsASlackTrussToItsClosedForm) {
  const Solved s = solve_with("lbfgs", two_bar_truss(), preconditioned_by(GetParam()));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_LT(distance(s.position(2), kJointOfTruss), 1e-9);
}

TEST_P(LbfgsWith, FindsTheSlackPanelThatTheUndampedNewtonDoesNot) {
  const Scene slack = sample::hanging_panel(8, 34);
  EXPECT_EQ(solve_with("newton", slack, {{"method", std::string("classic")}}).solution.status,
            SolveStatus::not_converged);
  const Level want = read_level("hanging-panel.txt", 8);
  const Solved s = solve_with("lbfgs", slack, preconditioned_by(GetParam()));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_NEAR(s.solution.energy, want.values[0], 1e-9 * std::abs(want.values[0]));
  EXPECT_NEAR(s.lowest_z(), want.values[2], 1e-8);
}

INSTANTIATE_TEST_SUITE_P(EveryPreconditioner, LbfgsWith, testing::Values("stiffness", "diagonal", "none"),
                         [](const auto& given) { return std::string(given.param); });

// Irvine's catenary, whose digits verification/rope_test.cpp has: 40 bars that sag are within 4e-6 m of it.
TEST(Lbfgs, HangsARopeInACatenary) {
  const SolvedFile s = solve_file(
      "hanging-rope.toml", {"analysis.solver=\"lbfgs\"", "parts.rope.rope.sag=1", "parts.rope.cells=40"});
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_NEAR(s.solved.position(s.node("rope", "middle"))[2], -2.95736530, 5e-6);
}

TEST(Lbfgs, FactorisesTheLinearStiffnessOnceAndNothingElse) {
  const Solved s = solve_with("lbfgs", sample::hanging_panel(8, 34));
  EXPECT_EQ(s.solution.books.factorisations, 1);
  EXPECT_EQ(s.solution.books.matrices, 0);
  const Solved diagonal = solve_with("lbfgs", sample::hanging_panel(8, 34), preconditioned_by("diagonal"));
  EXPECT_EQ(diagonal.solution.books.factorisations, 0);
}

TEST(Lbfgs, TakesFewerStepsWithTheLinearStiffness) {
  const auto residuals = [](const char* word) {
    return solve_with("lbfgs", sample::hanging_panel(8, 34), preconditioned_by(word))
        .solution.books.residuals;
  };
  EXPECT_LT(2 * residuals("stiffness"), residuals("none"));
}

TEST(Lbfgs, RefusesForcesWithoutAnEnergy) {
  const Solved s = solve_with("lbfgs", pushed_bar(5));
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "lbfgs needs a problem that is conservative")) << s.solution.reason;
}

TEST(Lbfgs, SaysThatNothingHoldsALoad) {
  const Solved s = solve_with("lbfgs", loose_load());
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "singular")) << s.solution.reason;
}

TEST(Lbfgs, HasNothingToFindWhereAllIsHeld) {
  const Solved s = solve_with("lbfgs", bar_between_supports());
  EXPECT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_NEAR(s.reaction(1)[0], 10, 1e-12);
}

TEST(Lbfgs, NamesTheElementThatHasNoForceAtTheStart) {
  const Solved s = solve_with("lbfgs", bar_without_forces());
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_EQ(s.solution.at_fault, "picky element 0");
}

TEST(Lbfgs, StopsWhenToleranceIsBelowRoundOff) {
  Limits limits;
  limits.tolerance = 1e-300;
  const Solved s = solve_with("lbfgs", sample::hanging_rope(20), {}, limits);
  EXPECT_LT(s.solution.balance.residual, 1e-9 * s.solution.balance.scale);
}

TEST(Lbfgs, StopsAtTheLimit) {
  Limits limits;
  limits.iterations = 3;
  const Solved s = solve_with("lbfgs", sample::hanging_panel(8, 34), {}, limits);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "limit of 3 iterations")) << s.solution.reason;
}

}  // namespace
}  // namespace netloft::test
