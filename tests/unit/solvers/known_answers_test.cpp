// SPDX-License-Identifier: BSD-3-Clause
//
// Known answers that solvers of different kinds must find. The test of each solver is built with this file.
#include <cmath>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/ways_to_known_answers.hpp"
#include "tests/verification/reference.hpp"

namespace netloft::test {
namespace {

TEST_P(KnownAnswers, PullsASlackTrussToItsClosedForm) {
  const Solved s = solve_so(two_bar_truss());
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_LT(distance(s.position(2), kJointOfTruss), 1e-9);
}

// Irvine's catenary, as in verification/rope_test.cpp: 40 bars with the term `sag` are within 4e-6 m of it.
TEST_P(KnownAnswers, HangsARopeInACatenary) {
  const SolvedFile s = solve_file_so("hanging-rope.toml", {"parts.rope.rope.sag=1", "parts.rope.cells=40"});
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_NEAR(s.solved.position(s.node("rope", "middle"))[2], -2.95736530, 5e-6);
}

// The panel is hard to solve: Newton.DoesNotFindASlackPanelUndamped.
TEST_P(KnownAnswers, FindsASlackPanel) {
  const Level want = read_level("hanging-panel.txt", 8);
  const Solved s = solve_so(sample::hanging_panel(8, 34));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_NEAR(s.solution.energy, want.values[0], 1e-9 * std::abs(want.values[0]));
  EXPECT_NEAR(s.lowest_z(), want.values[2], 1e-8);
}

TEST_P(KnownAnswers, HasNothingToFindWhereAllIsHeld) {
  const Solved s = solve_so(bar_between_supports());
  EXPECT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_NEAR(s.reaction(1)[0], 10, 1e-12);
}

TEST_P(KnownAnswers, NamesTheElementThatHasNoForceAtTheStart) {
  const Solved s = solve_so(bar_without_forces());
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_EQ(s.solution.at_fault, "picky element 0");
}

TEST_P(KnownAnswers, SaysThatItDidNotArriveWhereNothingHoldsALoad) {
  Limits limits;
  limits.iterations = 40;  // a step that has been halved 26 times has no effect
  const Solved s = solve_so(loose_load(), limits);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, GetParam().of_a_loose_load)) << s.solution.reason;
}

TEST_P(KnownAnswers, StopsAtTheLimit) {
  Limits limits;
  limits.iterations = 2;
  const Solved s = solve_so(sample::hanging_panel(8, 34), limits);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "limit of 2 iterations")) << s.solution.reason;
  EXPECT_EQ(s.solution.cost.statistics.iterations, 2);
}

TEST_P(KnownAnswersWithoutEnergy, FindsARopeInACurrent) {
  const Level want = read_level("towed-cable-in-bars.txt", 10);
  const SolvedFile s = solve_file_so("verification/towed-rope.toml", {"parts.rope.cells=10"});
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  const auto top = s.solved.reaction(s.node("rope", "start"));
  EXPECT_NEAR(top[0], want.values[0], 1e-6);
  EXPECT_NEAR(top[2], want.values[1], 1e-6);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(KnownAnswersWithoutEnergy);

}  // namespace
}  // namespace netloft::test
