// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/tension/interior_point.hpp"

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/tension/taken_as_members.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::tension {
namespace {

using Ending = InteriorPoint::Ending;

struct Found {
  Ending ending;
  bool is_near;
  int iterations;
  std::vector<double> positions;
};

Found find(const Scene& scene, double load = 1000, const Limits& limits = {},
           const InteriorPoint::Parameters& parameters = defaults<Only>()) {
  TakenAsMembers taken(scene, limits);
  InteriorPoint method(parameters, taken.problem.interface());
  const Ending ending = method.solve(taken.u, load);
  return {ending, method.is_near(), taken.problem.statistics().iterations, taken.positions()};
}

/// A weight of 100 N in sea water that hangs on two ropes from one point, of 3 m and 2 m, both drawn far too
/// long and aslant.
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

// The shorter rope bears all: l = l₀ (1 + P/EA).
TEST(InteriorPoint, TellsTheTautRopeFromTheSlackOne) {
  for (const double EA : {1e3, 1e5, 1e8}) {
    const Found found = find(two_ropes(EA));
    ASSERT_EQ(found.ending, Ending::converged);
    EXPECT_NEAR(found.positions[5], -2 * (1 + 100 / EA), 1e-6);
    EXPECT_NEAR(std::hypot(found.positions[3], found.positions[4]), 0, 1e-4);
    EXPECT_LT(found.iterations, 20);
  }
}

// The longer rope, compressed between the point and the weight, pushes it down:
//   EA (l/2 − 1) = P + E_c (1 − l/3)
TEST(InteriorPoint, EndsWhereCompressionLeavesTheMembers) {
  constexpr double EA = 1e4, kCompression = 6;
  const Scene scene = two_ropes(EA, kCompression);
  const auto length = [](double E_c) { return (100 + EA + E_c) / (EA / 2 + E_c / 3); };
  const Found found = find(scene), little = find(scene, 50);
  ASSERT_EQ(found.ending, Ending::converged);
  ASSERT_EQ(little.ending, Ending::converged);
  EXPECT_NEAR(found.positions[5], -length(kCompression), 1e-6);
  EXPECT_NEAR(little.positions[5], -length(0.5), 1e-6) << "a hundredth of a load that is too little";
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
  EXPECT_LE(confirmed.solution.statistics.iterations, 2);
  EXPECT_NEAR(confirmed.lowest_z(), direct.lowest_z(), 1e-4);
}

TEST(InteriorPoint, EndsAtItsOwnLimitAndAtTheHosts) {
  const Scene panel = sample::hanging_panel(8, 30);
  auto few = defaults<Only>();
  few.iterations = 3;
  const std::atomic<bool> now = true;
  const Found of_own = find(panel, 1000, {}, few), of_host = find(panel, 1000, {.iterations = 3}),
              interrupted = find(panel, 1000, {.interrupt = &now});
  EXPECT_EQ(of_own.ending, Ending::called_off);
  EXPECT_EQ(of_own.iterations, 3);
  EXPECT_EQ(of_host.ending, Ending::called_off);
  EXPECT_EQ(of_host.iterations, 3);
  EXPECT_EQ(interrupted.ending, Ending::called_off);
  EXPECT_EQ(interrupted.iterations, 0);
}

TEST(InteriorPoint, IsNearWhereLittleIsLeftThoughIterationsAreSpent) {
  const Scene panel = sample::hanging_panel(8, 30);
  const int needed = find(panel).iterations;
  bool was_near = false;
  for (int less = 1; less <= 4; ++less) {
    const Found found = find(panel, 1000, {.iterations = needed - less});
    EXPECT_EQ(found.ending, Ending::called_off);
    was_near = was_near || found.is_near;
  }
  EXPECT_TRUE(was_near);
  EXPECT_FALSE(find(panel, 1000, {.iterations = 3}).is_near);
}

}  // namespace
}  // namespace netloft::tension
