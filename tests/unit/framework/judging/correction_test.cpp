// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/correction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

Solved solve_sketch(const Scene& scene, double tolerance) {
  plugins();  // makes the elements "test/…" known
  Solving how;
  how.limits.tolerance = tolerance;
  return solve(scene, how);
}

/// A bar of 1 m and EA = 10 kN along z, with the initial length `height` and a force `load` at its head.
Scene standing_bar(double load, double height) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto foot = s.node(0, 0, 0, kAllAxes), head = s.node(0, 0, height);
  s.rope("bar", {foot, head}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  s.part("load", "test/load", {{"z", load}}, {head});
  return s.scene;
}

/// The tolerance accepts the start, so that no iteration is made. Computed by hand: 100 N stretch the bar by
/// 0.01 m, and at the start it is stretched by half of this length.
TEST(Correction, IsTheWayToTheEquilibriumWhereForcesAreLinear) {
  const Solved s = solve_sketch(standing_bar(100, 1.005), 1);
  EXPECT_EQ(s.solution.cost.statistics.iterations, 0);
  EXPECT_NEAR(s.solution.correction.length, 0.005, 1e-14);
  const auto z = s.assembler->numbering().dof(1, 2).at();
  EXPECT_NEAR(s.solution.correction.x[z], 1.01, 1e-14);
  EXPECT_EQ(s.solution.x[z], 1.005);
}

TEST(Correction, IsKnownAtAnUnstableEquilibriumToo) {
  const Solved s = solve_sketch(standing_bar(-100, 0.995), 1);
  EXPECT_EQ(s.solution.status, SolveStatus::unstable);
  EXPECT_NEAR(s.solution.correction.length, 0.005, 1e-14);
}

TEST(Correction, IsKnownWhereForcesHaveNoEnergy) {
  Sketch sketch;
  sketch.scene.water.gravity = 0;
  const auto top = sketch.node(0, 0, 0, kAllAxes), end = sketch.node(0, 0, -1.5);
  sketch.rope("bar", {top, end}, 1, 100);
  sketch.part("load", "test/load", {{"z", -50.0}}, {end});
  sketch.part("push", "test/follower", {{"k", 1.0}}, {top, end}).data["rest_length"] = {1};
  const Solved loose = solve_sketch(sketch.scene, 1e-3), tight = solve_sketch(sketch.scene, 1e-14);
  const double distance =
      largest_node_distance(tight.scene, tight.assembler->numbering(), loose.solution.x, tight.solution.x);
  ASSERT_GT(distance, 1e-9);
  EXPECT_NEAR(loose.solution.correction.length / distance, 1, 0.1);
}

TEST(Correction, TellsTheErrorOfALooselySolvedPanel) {
  const Scene panel = sample::hanging_panel(8, 34);
  const Solved tight = solve_sketch(panel, 1e-13);
  int told = 0;
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const Solved loose = solve_sketch(panel, tolerance);
    const double distance =
        largest_node_distance(tight.scene, tight.assembler->numbering(), loose.solution.x, tight.solution.x);
    if (distance < 1e-11) continue;  // the last step of the solver was more accurate than its tolerance
    ++told;
    EXPECT_LT(loose.solution.correction.length, 2 * distance) << tolerance;
    EXPECT_GT(loose.solution.correction.length, 0.5 * distance) << tolerance;
  }
  EXPECT_GE(told, 2);
}

TEST(Correction, IsNotKnownWhereNothingIsBalanced) {
  Solving how;
  how.limits.iterations = 2;
  const Solved s = solve(sample::hanging_panel(4, 34), how);
  EXPECT_TRUE(std::isnan(s.solution.correction.length));
  EXPECT_TRUE(s.solution.correction.x.empty());
}

/// A quarter turn counts as the distance √2 r that the carried point moves, not as 1.57 m.
TEST(NodeDistance, CountsRotationsOfBodiesByWhatTheyMove) {
  Sketch s;
  const auto origin = s.node(0, 0, 0), carried = s.node(0.5, 0, 0);
  s.scene.add_body({.name = "board", .origin = origin, .points = {{carried, {0.5, 0, 0}}}});
  const Assembled a(s.scene);
  std::vector<double> u(6), turned(a.assembler.start());
  u[5] = 0.5 * std::numbers::pi / 2;  // the unknown is the rotation times the arm
  a.assembler.place(u, turned);
  EXPECT_NEAR(largest_node_distance(s.scene, a.assembler.numbering(), a.assembler.start(), turned),
              0.5 * std::sqrt(2.0), 1e-15);
}

}  // namespace
}  // namespace netloft::test
