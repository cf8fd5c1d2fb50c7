// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/interior_point.hpp"

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/strategies/tension/taken_as_members.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::tension {
namespace {

using Ending = InteriorPoint::Ending;

struct Found {
  Ending ending;
  int iterations;
  std::vector<double> positions;
};

Found find(const Scene& scene, double load = 1000, const Limits& limits = {}) {
  TakenAsMembers taken(scene, limits);
  InteriorPoint method(defaults<Only>(), taken.problem.interface());
  const Ending ending = method.solve(taken.u, load);
  return {ending, taken.problem.statistics().iterations, taken.positions()};
}

/// A weight of 100 N in sea water that hangs from one point on two ropes of 3 m and 2 m; in the sketch both
/// are far too long and inclined.
Scene two_ropes(double EA, double EA_compression = 0) {
  test::Sketch s;
  const auto top = s.node(0, 0, 0, kAllAxes), weight = s.node(5, -4, 1);
  for (const double l0 : {3.0, 2.0}) {
    Part& rope = s.rope(l0 > 2 ? "long" : "short", {top, weight}, l0, EA);
    rope.parameters["rope.density"] = 1025.0, rope.parameters["rope.EA_compression"] = EA_compression;
  }
  s.part("weight", "float/float", {{"float.buoyancy", -100.0}, {"float.diameter", 0.1}}, {weight})
      .data["pieces"] = {1};
  return s.scene;
}

// The shorter rope bears the whole weight P: l = l₀ (1 + P/EA).
TEST(InteriorPoint, TellsTheTautRopeFromTheSlackOne) {
  for (const double EA : {1e3, 1e5, 1e8}) {
    const Found found = find(two_ropes(EA));
    ASSERT_EQ(found.ending, Ending::converged);
    EXPECT_NEAR(found.positions[5], -2 * (1 + 100 / EA), 3e-7);  // l₀ μ/T, μ 1.5e-8 of the load of 1000 N
    EXPECT_NEAR(std::hypot(found.positions[3], found.positions[4]), 0, 1e-3);
    EXPECT_LT(found.iterations, 20);
  }
}

// The interior-point method neglects the stiffness of members in compression.
TEST(InteriorPoint, EndsWhereNothingIsBorneByCompression) {
  const Found found = find(two_ropes(1e4, 6));
  ASSERT_EQ(found.ending, Ending::converged);
  EXPECT_NEAR(found.positions[5], -2 * (1 + 100 / 1e4), 2e-6);
}

// Both ropes of the sketch are 6.5 m long; made 10 m long, the second one is slack.
TEST(InteriorPoint, CountsSlackMembersByTheirLength) {
  Scene scene = two_ropes(1e4);
  for (const double l0 : {2.0, 10.0}) {
    scene.parts[1].data["rest_length"] = {l0};
    TakenAsMembers taken(scene, {});
    InteriorPoint method(defaults<Only>(), taken.problem.interface());
    EXPECT_DOUBLE_EQ(method.slack_fraction(taken.u), l0 > 6.5 ? 10.0 / 13 : 0.0);
  }
}

TEST(InteriorPoint, LeadsAPanelThatStartsSlackToWhereItHangs) {
  Scene panel = sample::hanging_panel(8, 30);
  for (Part& part : panel.parts) part.parameters["twine.EA_compression"] = 0.0;
  const Found found = find(panel);
  ASSERT_EQ(found.ending, Ending::converged);
  Scene there = panel;
  there.positions = found.positions;
  const test::Solved confirmed = test::solve(there, {{}, {.tolerance = 1e-5}}), direct = test::solve(panel);
  ASSERT_EQ(confirmed.solution.status, SolveStatus::converged) << confirmed.solution.reason;
  EXPECT_LE(confirmed.solution.cost.statistics.iterations, 4);
  EXPECT_NEAR(confirmed.lowest_z(), direct.lowest_z(), 1e-4);
}

TEST(InteriorPoint, EndsWhereTheHostGivesUp) {
  const Scene panel = sample::hanging_panel(8, 30);
  const std::atomic<bool> now = true;
  const Found few = find(panel, 1000, {.iterations = 3}),
              interrupted = find(panel, 1000, {.interrupt = &now});
  EXPECT_EQ(few.ending, Ending::called_off);
  EXPECT_EQ(few.iterations, 3);
  EXPECT_EQ(interrupted.ending, Ending::called_off);
  EXPECT_EQ(interrupted.iterations, 0);
}

}  // namespace
}  // namespace netloft::tension
