// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/known_answers.hpp"

namespace netloft::test {
namespace {

/// Two bars of 1 m in one line between ends that are 2 m minus `short_by` apart, with a force of 0.1 N along
/// the line at their joint, node 1.
Scene pressed_line(double short_by) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0), c = s.node(2 - short_by, 0, 0, kAllAxes);
  s.rope("bars", {a, b, c}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  s.part("load", "test/load", {{"x", 0.1}}, {b});
  return s.scene;
}

double away_from_line(const Solved& s) { return std::hypot(s.position(1)[1], s.position(1)[2]); }

// The joint of two bars of 1 m between ends 2 m − δ apart is √(δ − δ²/4) off the line, by Pythagoras.
TEST(Newton, LeavesASaddleThatSymmetryHidesWhileItSolves) {
  for (const double short_by : {1e-7, 1e-6, 2e-5, 1e-4}) {
    const Solved s = solve_with("newton", pressed_line(short_by), {{"damping", 0.0}});
    ASSERT_EQ(s.solution.status, SolveStatus::converged) << short_by << ": " << s.solution.reason;
    EXPECT_NEAR(away_from_line(s), std::sqrt(short_by), 1e-2 * std::sqrt(short_by));
  }
}

// A stretched bar between held ends stores so much energy that rounding hides the gain of every step.
TEST(Newton, LeavesASaddleWhereEnergiesCanNoLongerBeToldApart) {
  constexpr double kShort = 1e-5;
  Sketch more;
  more.scene = pressed_line(kShort);
  more.scene.positions[4] = 1e-3;
  const auto from = more.node(0, 5, 0, kAllAxes), to = more.node(1.5, 5, 0, kAllAxes);
  more.rope("stretched", {from, to}, 1, 1e4);
  const Solved s = solve_with("newton", more.scene, {});
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_GT(s.solution.energy, 1e3);
  EXPECT_NEAR(away_from_line(s), std::sqrt(kShort), 1e-2 * std::sqrt(kShort));
}

TEST(Newton, DoesNotFindASlackPanelUndamped) {
  const Solved s = solve_with("newton", sample::hanging_panel(8, 34), {{"method", std::string("classic")}});
  EXPECT_EQ(s.solution.status, SolveStatus::not_converged);
}

TEST(Newton, StaysOnALineThatIsPulled) {
  const Solved s = solve_with("newton", pressed_line(-1e-7), {{"damping", 0.0}});
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_EQ(away_from_line(s), 0);
}

/// A triangle of netting, held by three bars that meet in node 0, and pushed away from node 0 by a force of
/// 1000 N. The line of this force goes through node 0 however the triangle rotates. Only a spring of 1 N at
/// its first corner determines the rotation; the triangle starts a quarter turn away.
Scene pressed_kite() {
  Sketch s;
  s.scene.water.gravity = 0;
  constexpr double kEA = 1e5;
  const double h = std::sqrt(0.75);
  const auto top = s.node(0, 0, 0, kAllAxes), a = s.node(0, -1, 1), b = s.node(-h, -1, -0.5),
             c = s.node(h, -1, -0.5), tie = s.node(9, 0, 1, kAllAxes);
  s.rope("leg a", {top, a}, std::sqrt(2), kEA);
  s.rope("legs b and c", {b, top, c}, std::sqrt(2), kEA);
  s.rope("rim", {a, b, c, a}, std::sqrt(3), kEA).parameters["rope.EA_compression"] = kEA;
  s.rope("spring", {a, tie}, 4, 1);
  Part& pressed = s.part("catch", "catch/pressure",
                         {{"catch.pressure", 1000 / (1.5 * h)}, {"catch.meshes", 1.0}}, {a, b, c});
  pressed.data["to_aft"] = {1, 0, 0};
  pressed.data["outward"] = {1};
  return s.scene;
}

// In equilibrium, the line of the spring goes through node 0, to within the 1 % by which the bars stretch.
TEST(Newton, TurnsAGearWithTheForcesThatTurnWithIt) {
  const Solved s = solve_with("newton", pressed_kite(), {}, {.iterations = 200});
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  const auto corner = s.position(1);
  EXPECT_GT(corner[0], 1.4);
  EXPECT_NEAR(corner[1], 0, 0.01);
  EXPECT_NEAR(corner[2], corner[0] / 9, 0.01);
}

}  // namespace
}  // namespace netloft::test
