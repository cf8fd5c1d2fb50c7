// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/known_answers.hpp"
#include "tests/verification/reference.hpp"
#include "tests/verification/scene_file.hpp"

namespace netloft::test {
namespace {

TEST(PseudoTransient, PullsASlackTrussToItsClosedForm) {
  const Solved s = solve_with("ptc", two_bar_truss());
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_LT(distance(s.position(2), kJointOfTruss), 1e-9);
}

// Irvine's catenary, whose digits verification/rope_test.cpp has: 40 bars that sag are within 4e-6 m of it.
TEST(PseudoTransient, HangsARopeInACatenary) {
  const SolvedFile s = solve_file(
      "hanging-rope.toml", {"analysis.solver=\"ptc\"", "parts.rope.rope.sag=1", "parts.rope.cells=40"});
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  EXPECT_NEAR(s.solved.position(s.node("rope", "middle"))[2], -2.95736530, 5e-6);
}

TEST(PseudoTransient, FindsTheSlackPanelThatTheUndampedNewtonDoesNot) {
  const Scene slack = sample::hanging_panel(8, 34);
  EXPECT_EQ(solve_with("newton", slack, {{"method", std::string("classic")}}).solution.status,
            SolveStatus::not_converged);
  const Level want = read_level("hanging-panel.txt", 8);
  const Solved s = solve_with("ptc", slack);
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_NEAR(s.solution.energy, want.values[0], 1e-9 * std::abs(want.values[0]));
  EXPECT_NEAR(s.lowest_z(), want.values[2], 1e-8);
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

TEST(PseudoTransient, FindsARopeInACurrent) {
  const Level want = read_level("towed-cable-in-bars.txt", 10);
  const SolvedFile s =
      solve_file("verification/towed-rope.toml", {"analysis.solver=\"ptc\"", "parts.rope.cells=10"});
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  const auto top = s.solved.reaction(s.node("rope", "start"));
  EXPECT_NEAR(top[0], want.values[0], 1e-6);
  EXPECT_NEAR(top[2], want.values[1], 1e-6);
}

TEST(PseudoTransient, BalancesAForceThatHasNoEnergy) {
  const Solved s = solve_with("ptc", pushed_bar(5));
  const Solved by_newton = solve_with("newton", pushed_bar(5));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(s.position(1)[axis], by_newton.position(1)[axis], 1e-8);
}

// From steps that never grow, (1) does not become Newton's method.
TEST(PseudoTransient, EndsAsNewtonsMethodBecauseStepsGrow) {
  const auto iterations = [](double growth) {
    return solve_with("ptc", two_bar_truss(), {{"step", 10.0}, {"growth", growth}}).solution.books.iterations;
  };
  EXPECT_LT(2 * iterations(10), iterations(1));
}

TEST(PseudoTransient, TakesBackAStepThatLeadsTooFar) {
  const Solved s = solve_with("ptc", two_bar_truss(), {{"reach", 0.1}});
  EXPECT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_TRUE(has_note(s, "taken back"));
}

TEST(PseudoTransient, SaysThatNothingHoldsALoad) {
  const Solved s = solve_with("ptc", loose_load());
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "singular")) << s.solution.reason;
}

TEST(PseudoTransient, HasNothingToFindWhereAllIsHeld) {
  const Solved s = solve_with("ptc", bar_between_supports());
  EXPECT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_NEAR(s.reaction(1)[0], 10, 1e-12);
}

TEST(PseudoTransient, NamesTheElementThatHasNoForceAtTheStart) {
  const Solved s = solve_with("ptc", bar_without_forces());
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_EQ(s.solution.at_fault, "picky element 0");
}

TEST(PseudoTransient, StopsAtTheLimit) {
  Limits limits;
  limits.iterations = 3;
  const Solved s = solve_with("ptc", sample::hanging_panel(8, 34), {}, limits);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "limit of 3 iterations")) << s.solution.reason;
}

const Values kImplicit{{"method", std::string("implicit")}};

TEST(ImplicitSteps, PullASlackTrussToItsClosedForm) {
  const Solved s = solve_with("ptc", two_bar_truss(), kImplicit);
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_LT(distance(s.position(2), kJointOfTruss), 1e-9);
}

TEST(ImplicitSteps, BalanceAForceThatHasNoEnergy) {
  const Solved s = solve_with("ptc", pushed_bar(5), kImplicit),
               by_newton = solve_with("newton", pushed_bar(5));
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(s.position(1)[axis], by_newton.position(1)[axis], 1e-8);
}

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
  EXPECT_LT(s.solved.solution.books.iterations, 60);
}

TEST(ImplicitSteps, GiveUpWhatGoesRoundForEver) {
  Limits limits;
  limits.way = 10;
  EXPECT_EQ(solve_with("ptc", pushed_bar(5), kImplicit, limits).solution.status, SolveStatus::converged);
  const Solved s = solve_with("ptc", whirling_bar(), kImplicit, limits);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "does not come to rest")) << s.solution.reason;
  EXPECT_LT(s.solution.books.iterations, 200);
}

TEST(ImplicitSteps, ThatLeadTooFarAreTakenBack) {
  const Solved s = solve_with("ptc", two_bar_truss(), {{"method", std::string("implicit")}, {"reach", 0.1}});
  EXPECT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_TRUE(has_note(s, "taken back"));
}

TEST(ImplicitSteps, NameTheElementThatHasNoForceAtTheStart) {
  const Solved s = solve_with("ptc", bar_without_forces(), kImplicit);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_EQ(s.solution.at_fault, "picky element 0");
}

}  // namespace
}  // namespace netloft::test
