// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/unit/solvers/ways_to_known_answers.hpp"

namespace netloft::test {
namespace {

constexpr Way kWay{.name = "Ptc", .solver = "ptc", .of_a_loose_load = "no step brings the gear closer"};
INSTANTIATE_TEST_SUITE_P(PseudoTransient, KnownAnswers, testing::Values(kWay), name_of);
INSTANTIATE_TEST_SUITE_P(PseudoTransient, KnownAnswersWithoutEnergy, testing::Values(kWay), name_of);

TEST(PseudoTransient, BalancesAForceThatHasNoEnergy) {
  const Solved s = solve_with("ptc", pushed_bar(5)), by_newton = solve_with("newton", pushed_bar(5));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(s.position(1)[axis], by_newton.position(1)[axis], 1e-8);
}

TEST(PseudoTransient, TakesBackStepsWhoseCorrectionsDoNotGetThere) {
  const Solved s = solve_with("ptc", two_bar_truss(), {{"corrections", std::int64_t{2}}});
  EXPECT_TRUE(has_note(s, "taken back"));
}

// The undamped Newton method ends with the bar upright, 1 m x (1 − 10 N/100 N) long, which is unstable.
TEST(PseudoTransient, LeavesAnEquilibriumThatIsNotStable) {
  const Solved up = solve_with("newton", toppling_bar(1e-3), {{"method", std::string("classic")}});
  EXPECT_NEAR(up.position(1)[2], 0.9, 1e-6) << up.solution.reason;
  const Solved s = solve_with("ptc", toppling_bar(1e-3));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_NEAR(s.position(1)[2], -1.1, 1e-9);
}

// Newton's method takes short steps in the narrow part, because twines alternate between slack and taut.
TEST(PseudoTransient, FindsACodEndWithALongNarrowNeck) {
  const SolvedFile s = solve_file(
      "verification/codend-with-catch.toml",
      {"analysis.solver=\"ptc\"", "parts.codend.panel.across=76", "parts.codend.panel.along=108",
       "parts.codend.cells=[14,20]", "parts.codend.tube.radius=0.2072", "parts.codend.twine.EA=39694.6",
       "parts.catch.catch.meshes=20", "parts.catch.catch.pressure=413.2"});
  EXPECT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_LT(s.solved.solution.cost.statistics.iterations, 60);
}

TEST(PseudoTransient, GivesUpWhatGoesRoundForEver) {
  Limits limits;
  limits.path = 10;
  EXPECT_EQ(solve_with("ptc", pushed_bar(5), {}, limits).solution.status, SolveStatus::converged);
  const Solved s = solve_with("ptc", whirling_bar(), {}, limits);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "does not come to rest")) << s.solution.reason;
  EXPECT_LT(s.solution.cost.statistics.iterations, 200);
}

}  // namespace
}  // namespace netloft::test
