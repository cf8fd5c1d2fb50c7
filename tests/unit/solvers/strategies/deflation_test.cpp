// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/unit/solvers/known_answers.hpp"

namespace netloft::test {
namespace {

/// Two bars of 1 m with EA = 10 kN in tension and compression, between ends 1.8 m apart; their joint moves in
/// a plane and is pulled down by `load`. In equilibrium the joint is about √(1 − 0.81) above or below the
/// line of the ends, or nearly on the line with bars compressed to 0.9 m, which is unstable.
Scene arch(double load) {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(0.9, 0, 0.43, kAxisY), c = s.node(1.8, 0, 0, kAllAxes);
  s.rope("bars", {a, b, c}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  s.part("load", "test/load", {{"z", -load}}, {b});
  return s.scene;
}

Solved deflate(const Scene& scene, std::int64_t searches) {
  plugins();
  Solving how;
  how.solver = "newton", how.strategy = "deflation", how.work = 5000;
  how.strategy_parameters = {{"by", std::string("direct")}, {"searches", searches}};
  return solve(scene, how);
}

TEST(Deflation, FindsTheArchThatHangsBesideTheOneThatStands) {
  const Solved one = deflate(arch(1), 0), both = deflate(arch(1), 10);
  const double height = std::sqrt(1 - 0.81);
  ASSERT_EQ(one.solution.status, SolveStatus::converged) << one.solution.reason;
  EXPECT_NEAR(one.position(1)[2], height, 1e-3) << "from where it starts it stands";
  EXPECT_TRUE(one.solution.shapes.others.empty());
  ASSERT_EQ(both.solution.status, SolveStatus::converged) << both.solution.reason;
  EXPECT_NEAR(both.position(1)[2], -height, 1e-3) << "it has the least energy";
  ASSERT_EQ(both.solution.shapes.others.size(), 1u) << "no other is stable";
  EXPECT_NEAR(both.solution.shapes.others[0].energy, one.solution.energy, 1e-9);
}

// Midway between the ends there are three equilibria, the roots z of 2 EA (1/l₀ − 1/l) z = −P, l = (0.81 +
// z²)^½. Beyond either end of the line there is one, where a bar of 0.1 m pushes as hard as the other, of 1.9
// m, pulls.
TEST(Deflation, MeetsEveryRootOnce) {
  const Solved s = deflate(arch(1), 30);
  EXPECT_EQ(s.solution.shapes.restarts + 1, 5) << "answers";
  EXPECT_EQ(s.solution.shapes.times, 1);
}

}  // namespace
}  // namespace netloft::test
