// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/ways_to_known_answers.hpp"

namespace netloft::test {
namespace {

constexpr Way kRelaxation{.name = "Relaxation", .solver = "relaxation", .of_a_loose_load = "runs away"};
INSTANTIATE_TEST_SUITE_P(Dynamic, KnownAnswers, testing::Values(kRelaxation), name_of);
INSTANTIATE_TEST_SUITE_P(Dynamic, KnownAnswersWithoutEnergy, testing::Values(kRelaxation), name_of);

TEST(Relaxation, NeedsNoMatrixAndNoFactorisation) {
  const Solved s = solve_with("relaxation", sample::hanging_panel(8, 34));
  EXPECT_EQ(s.solution.cost.statistics.matrices, 0);
  EXPECT_EQ(s.solution.cost.statistics.factorisations, 0);
  EXPECT_GT(s.solution.cost.statistics.residuals, 1000);
}

// The push turns with the bar and drives it round and round, without a peak of the kinetic energy that ends
// the motion. (This happens with 5 N or more.)
TEST(Relaxation, SaysThatItDidNotArriveWhereForcesFeedTheMotion) {
  Limits limits;
  limits.iterations = 5;
  const Solved s = solve_with("relaxation", pushed_bar(8), {}, limits);
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
  EXPECT_TRUE(says(s, "runs away")) << s.solution.reason;
}

/// A spring with the energy k (l² − l₀²)²/(8 l₀²), l₀ = 1 m, k = 100 N/m. At l = 3 m the spring pulls with k
/// l (l² − 1)/2 = 1200 N, and its stiffness is k (3 l² − 1)/2 = 1300 N/m, 13 times the stiffness at l₀.
Scene stiffening_spring() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto top = s.node(0, 0, 0, kAllAxes), end = s.node(0, 0, -1);
  s.part("spring", "test/spring", {{"k", 100.0}}, {top, end}).data["rest_length"] = {1};
  s.part("load", "test/load", {{"z", -1200.0}}, {end});
  return s.scene;
}

TEST(Relaxation, RaisesMassesThatTheStiffnessHasOutgrown) {
  const Solved s = solve_with("relaxation", stiffening_spring(), {{"steps", std::int64_t{1}}});
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_TRUE(has_note(s, "heavier masses"));
  EXPECT_NEAR(s.position(1)[2], -3, 1e-9);
}

/// The element has the energy ½ l², and its force is not defined beyond l = 1 m. Under a pull of 0.9 N it
/// comes to rest at 0.9 m, but the first motion goes beyond 1 m.
TEST(Relaxation, ReturnsFromWhereThereAreNoForces) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(-0.9, 0, 0);
  s.part("picky", "test/picky", {{"limit", 1.0}}, {a, b}).data["rest_length"] = {1};
  s.part("load", "test/load", {{"x", 0.9}}, {b});
  const Solved solved = solve_with("relaxation", s.scene, {{"steps", std::int64_t{1}}});
  EXPECT_EQ(solved.solution.status, SolveStatus::converged) << solved.solution.reason;
  EXPECT_NEAR(solved.position(1)[0], 0.9, 1e-9);
}

TEST(Relaxation, CountsSoManyStepsAsOneIteration) {
  Limits limits;
  limits.iterations = 3;
  const Solved s =
      solve_with("relaxation", sample::hanging_panel(8, 34), {{"steps", std::int64_t{7}}}, limits);
  EXPECT_EQ(s.solution.cost.statistics.iterations, 3);
  EXPECT_GE(s.solution.cost.statistics.residuals, 1 + 3 * 7);
  EXPECT_LE(s.solution.cost.statistics.residuals, 1 + 2 * 3 * 7)
      << "at most one more evaluation a step, at a peak";
}

}  // namespace
}  // namespace netloft::test
