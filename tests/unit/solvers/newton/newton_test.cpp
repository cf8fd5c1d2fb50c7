// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/solvers/known_answers.hpp"

namespace netloft::test {
namespace {

/// Two bars of 1 m between ends too near by `short_by`, in one line, and a force of 0.1 N along it at their
/// joint, node 1.
Scene pressed_line(double short_by) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0), c = s.node(2 - short_by, 0, 0, kAllAxes);
  s.rope("bars", {a, b, c}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  s.part("load", "test/load", {{"x", 0.1}}, {b});
  return s.scene;
}

double away_from_line(const Solved& s) { return std::hypot(s.position(1)[1], s.position(1)[2]); }

// By Pythagoras the joint of two bars of 1 m is √(δ − δ²/4) off the line between ends 2 m − δ apart.
TEST(Newton, LeavesASaddleThatSymmetryHidesWhileItSolves) {
  constexpr double kShort = 1e-7;
  const Solved s = solve_with("newton", pressed_line(kShort), {{"damping", 0.0}});
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_NEAR(away_from_line(s), std::sqrt(kShort), 1e-2 * std::sqrt(kShort));
}

TEST(Newton, StaysOnALineThatIsPulled) {
  const Solved s = solve_with("newton", pressed_line(-1e-7), {{"damping", 0.0}});
  ASSERT_EQ(s.solution.status, SolveStatus::converged) << s.solution.reason;
  EXPECT_EQ(away_from_line(s), 0);
}

}  // namespace
}  // namespace netloft::test
