// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/unit/solvers/ways_to_known_answers.hpp"

namespace netloft::test {
namespace {

constexpr Way kWays[] = {
    {"LinearlyImplicit", "ptc"},
    {"Implicit", "ptc", "method", "implicit", "no step brings it closer"},
};
INSTANTIATE_TEST_SUITE_P(PseudoTransient, KnownAnswers, testing::ValuesIn(kWays), name_of);
INSTANTIATE_TEST_SUITE_P(PseudoTransient, KnownAnswersWithoutEnergy, testing::ValuesIn(kWays), name_of);

class EveryStep : public KnownAnswers {};

TEST_P(EveryStep, BalancesAForceThatHasNoEnergy) {
  const Solved s = solve_so(pushed_bar(5)), by_newton = solve_with("newton", pushed_bar(5));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(s.position(1)[axis], by_newton.position(1)[axis], 1e-8);
}

INSTANTIATE_TEST_SUITE_P(PseudoTransient, EveryStep, testing::ValuesIn(kWays), name_of);

TEST(LinearlyImplicitSteps, AreTakenBackWhereTheyLeadTooFar) {
  const Solved s = solve_with("ptc", two_bar_truss(), {{"reach", 0.1}});
  EXPECT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_TRUE(has_note(s, "taken back"));
}

TEST(ImplicitSteps, AreTakenBackWhereTheirCorrectionsDoNotGetThere) {
  const Solved s = solve_with("ptc", two_bar_truss(),
                              {{"method", std::string("implicit")}, {"corrections", std::int64_t{2}}});
  EXPECT_TRUE(has_note(s, "taken back"));
}

// Pressed as stiffly as pulled, a short bar has a tangent that no small damping makes definite.
TEST(PseudoTransient, UsesTheConvexPartWhereTheTangentIsIndefinite) {
  Scene pressed = two_bar_truss();
  for (Part& part : pressed.parts)
    if (part.type == "rope/bar") part.parameters["rope.EA_compression"] = 1e4;
  const Solved s = solve_with("ptc", pressed);
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_TRUE(has_note(s, "convex part"));
  EXPECT_LT(distance(s.position(2), kJointOfTruss), 1e-9);
}

// From steps that never grow, (1) does not become Newton's method.
TEST(PseudoTransient, EndsAsNewtonsMethodBecauseStepsGrow) {
  const auto iterations = [](double growth) {
    return solve_with("ptc", two_bar_truss(), {{"step", 10.0}, {"growth", growth}})
        .solution.cost.statistics.iterations;
  };
  EXPECT_LT(2 * iterations(10), iterations(1));
}

const Values kImplicit{{"method", std::string("implicit")}};

// Undamped, Newton's method stands the bar up: 1 m x (1 − 10 N/100 N) is in balance, and topples.
TEST(ImplicitSteps, LeaveAnEquilibriumThatIsNotStable) {
  const Solved up = solve_with("newton", toppling_bar(1e-3), {{"method", std::string("classic")}});
  EXPECT_NEAR(up.position(1)[2], 0.9, 1e-6) << up.solution.reason;
  const Solved s = solve_with("ptc", toppling_bar(1e-3), kImplicit);
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_NEAR(s.position(1)[2], -1.1, 1e-9);
}

// Newton's method creeps there: its twines flicker between slack and taut.
TEST(ImplicitSteps, FindACodEndWithALongNarrowNeck) {
  const SolvedFile s = solve_file(
      "verification/codend-with-catch.toml",
      {"analysis.solver=\"ptc\"", "analysis.ptc.method=\"implicit\"", "parts.codend.panel.across=76",
       "parts.codend.panel.along=108", "parts.codend.cells=[14,20]", "parts.codend.tube.radius=0.2072",
       "parts.codend.twine.EA=39694.6", "parts.catch.catch.meshes=20", "parts.catch.catch.pressure=413.2"});
  EXPECT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_LT(s.solved.solution.cost.statistics.iterations, 60);
}

TEST(ImplicitSteps, GiveUpWhatGoesRoundForEver) {
  Limits limits;
  limits.path = 10;
  EXPECT_EQ(solve_with("ptc", pushed_bar(5), kImplicit, limits).solution.status, SolveStatus::converged);
  const Solved s = solve_with("ptc", whirling_bar(), kImplicit, limits);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "does not come to rest")) << s.solution.reason;
  EXPECT_LT(s.solution.cost.statistics.iterations, 200);
}

}  // namespace
}  // namespace netloft::test
