// SPDX-License-Identifier: BSD-3-Clause
#include "framework/continuation/journey.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solvers/factorisation/factorisation.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

/// Two bars of 1 m, as stiff pressed as pulled, straight between ends that are 1.8 m apart.
Scene pressed_bars() {
  Sketch s;
  s.scene.water.gravity = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(0.9, 0, 0), c = s.node(1.8, 0, 0, kAllAxes);
  s.rope("bars", {a, b, c}, 1, 1e4).parameters["rope.EA_compression"] = 1e4;
  return s.scene;
}

struct Travelled {
  Solution solution;
  double away = 0;  // of node 1 from the line [m]
};

Travelled travel(const Scene& scene, Limits limits = {}) {
  Registry& registry = shipped_plugins();
  const Plan plan = make_plan(scene, registry);
  Assembler assembler(scene, plan, 1);
  JourneyOptions options;
  options.solver.type = &registry.solver("newton");
  options.limits = limits, options.make = make_factorisation;
  Travelled t{Journey(scene, assembler, registry, options).arrive({}), 0};
  const auto at = [&](int axis) {
    return t.solution.x[static_cast<std::size_t>(assembler.numbering().index(1, axis))];
  };
  t.away = std::hypot(at(1), at(2));
  return t;
}

TEST(Journey, LeavesAPointThatIsInBalanceAndNotStable) {
  const Travelled t = travel(pressed_bars());
  EXPECT_EQ(t.solution.status, SolveStatus::converged) << t.solution.reason;
  EXPECT_NEAR(t.away, std::sqrt(1 - 0.81), 1e-6) << "the bars buckle until nothing presses them";
  ASSERT_GT(t.solution.legs.size(), 1u);
  EXPECT_EQ(t.solution.legs.front().status, SolveStatus::unstable);
}

TEST(Journey, AddsUpWhatAllItsLegsCost) {
  const Solution s = travel(pressed_bars()).solution;
  int factorisations = 0;
  for (const Leg& leg : s.legs) factorisations += leg.books.factorisations;
  EXPECT_EQ(s.books.factorisations, factorisations);
}

TEST(Journey, IsOneSolveWhereThatArrives) {
  Scene scene = pressed_bars();
  scene.positions[6] = 2.2;  // pulled
  const Travelled t = travel(scene);
  EXPECT_EQ(t.solution.status, SolveStatus::converged);
  EXPECT_TRUE(t.solution.legs.empty());
}

TEST(Journey, SaysSoWhereTimeIsUp) {
  Limits limits;
  limits.seconds = 0;
  EXPECT_NE(travel(pressed_bars(), limits).solution.status, SolveStatus::converged);
}

}  // namespace
}  // namespace netloft::test
