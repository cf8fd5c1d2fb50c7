// SPDX-License-Identifier: BSD-3-Clause
//
// The drag of elements in water that a flow changes (changed_water.hpp), with the shipped flow and ropes.
#include <gtest/gtest.h>

#include "framework/assembler/reports.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

#include <cmath>

namespace netloft::test {
namespace {

constexpr double kSpeed = 1.5, kDensity = 1025;

/// A frame of 4 m by 2 m across the current is the rim of a mouth of 8 m². Behind the frame, in reach of the
/// flow, are 100 bars of rope (more than one tile); ahead of it, out of reach, is one bar, whose drag counts
/// too.
Scene bag_in_current(const std::vector<Current::Sample>& current = {{0, {kSpeed, 0.2, 0}}}) {
  Sketch s;
  s.scene.current.samples = current;
  const auto a = s.node(0, -2, -9), b = s.node(0, 2, -9), c = s.node(0, 2, -7), d = s.node(0, -2, -7);
  s.part("flow", "flow/momentum", {}, {a, b, b, c, c, d, d, a});
  std::vector<std::uint32_t> behind;
  for (int i = 0; i < 100; ++i) {
    const double y = -2 + 0.04 * i;
    behind.insert(behind.end(), {s.node(1, y, -9), s.node(1.4, y, -7)});
  }
  const auto bars = [&](const char* name, const std::vector<std::uint32_t>& nodes, double reach) {
    Part& part = s.part(name, "rope/bar",
                        {{"rope.EA", 1e4}, {"rope.diameter", 0.02}, {"rope.density", 1000.0}}, nodes);
    part.data["rest_length"].assign(nodes.size() / 2, 2);
    part.flow = 0;
    part.reach.assign(nodes.size() / 2, reach);
  };
  bars("behind", behind, 1);
  bars("ahead", {s.node(-1, 0, -9), s.node(-1, 0.5, -7)}, 0);
  return s.scene;
}

std::size_t induction(const Assembled& a) {
  return a.assembler.numbering().dof(a.assembler.families()[0]->global_nodes()[0].node, 0).at();
}

/// The drag of all bars together along the current [N].
double drag(Assembled& a, const std::vector<double>& x) {
  const auto residual =
      a.assembler.reports().sum_terms(x, [](std::uint32_t t) { return (t & NETLOFT_IS_DRAG) != 0; });
  double sum = 0;
  for (std::uint32_t node = 0; node < a.scene.node_count(); ++node)
    for (int axis = 0; axis < 2; ++axis)
      sum -= residual[a.assembler.numbering().dof(node, axis).at()] *
             a.scene.current.samples[0].velocity[static_cast<std::size_t>(axis)];
  return sum / std::hypot(kSpeed, 0.2);
}

TEST(ChangedWater, HasTheUnknownOfItsFlow) {
  const Assembled a(bag_in_current());
  EXPECT_TRUE(a.assembler.numbering().is_unknown(Dof(induction(a))));
  EXPECT_EQ(a.plan.unknowns, static_cast<std::size_t>(a.assembler.numbering().unknowns()));
  EXPECT_EQ(a.assembler.node_name(a.scene, a.assembler.families()[0]->global_nodes()[0].node),
            "flow induction");
}

TEST(ChangedWater, DragsBySquareOfTheSpeedThatIsLeft) {
  Assembled a(bag_in_current());
  auto x = a.assembler.start();
  x[induction(a)] = 0;
  const double undisturbed = drag(a, x);
  x[induction(a)] = 0.3;
  const double slowed = drag(a, x);
  // One of 101 bars is out of reach; all have about the same drag.
  EXPECT_NEAR(slowed / undisturbed, (100 * 0.49 + 1) / 101, 0.002);
}

TEST(ChangedWater, BalancesTheThrustOfTheMouthAndTheDrag) {
  Assembled a(bag_in_current());
  auto x = a.assembler.start();
  for (const double induced : {0.0, 0.2, 0.4, 0.7}) {
    x[induction(a)] = induced;
    const double speed = std::hypot(kSpeed, 0.2), area = 8 * kSpeed / speed,
                 thrust = induced < 0.4 ? 4 * induced * (1 - induced)
                                        : 8.0 / 9 + induced * (-4.0 / 9 + 14.0 / 9 * induced);
    const double expected = thrust * 0.5 * kDensity * speed * speed * area - drag(a, x);
    EXPECT_NEAR(a.residual(x)[induction(a)], speed * expected, 1e-9 * std::abs(expected)) << induced;
  }
}

TEST(ChangedWater, HasItsRowAndColumnInTheTangent) {
  Assembled a(bag_in_current());
  auto x = a.moved(0.1);
  x[induction(a)] = 0.25;
  const auto exact = a.matrix(x, MatrixKind::exact);
  double largest = 0;
  for (const double entry : exact) largest = std::max(largest, std::abs(entry));
  EXPECT_LT(largest_difference(exact, difference(a, x, 1e-5)), 1e-7 * largest);
}

TEST(ChangedWater, HasItsTangentInACurrentThatChangesWithDepth) {
  Assembled a(bag_in_current({{-10, {1, 0.4, 0}}, {0, {2, 0, 0}}}));
  auto x = a.moved(0.1);
  x[induction(a)] = 0.25;
  EXPECT_LT(largest_difference(a.matrix(x, MatrixKind::exact), difference(a, x, 1e-5)), 1e-2);
}

/// Netting behind the mouth turns the water aside: three triangles at different angles to the current, and
/// one that is nearly folded to a line.
Scene netting_in_current() {
  Sketch s;
  s.scene.current.samples = {{-10, {1, 0.4, 0}}, {0, {2, 0, 0}}};
  const auto a = s.node(0, -2, -9), b = s.node(0, 2, -9), c = s.node(0, 2, -7), d = s.node(0, -2, -7);
  s.part("flow", "flow/momentum", {}, {a, b, b, c, c, d, d, a});
  const auto e = s.node(1, 0, -9), f = s.node(3, 1, -8), g = s.node(2, 0.5, -8.49);
  Part& net = s.part("net", "priour/triangle",
                     {{"twine.EA", 1e3}, {"twine.diameter", 0.002}, {"twine.density", 1000.0}},
                     {a, b, e, b, c, e, c, f, e, e, f, g});
  net.laws["drag"] = {"hydro/loland", {}};
  net.data["u"] = {0, 20, 0, 0, 20, 0, 0, 20, 0, 0, 20, 0};
  net.data["v"] = {0, 0, 20, 0, 0, 20, 0, 0, 20, 0, 0, 20};
  net.data["bar_length"].assign(4, 0.1);
  net.flow = 0;
  net.reach.assign(4, 1);
  return s.scene;
}

TEST(ChangedWater, HasItsTangentWhereNettingTurnsTheWaterAside) {
  Assembled a(netting_in_current());
  auto x = a.moved(0.005);
  x[induction(a)] = 0.25;
  const auto exact = a.matrix(x, MatrixKind::exact);
  EXPECT_LT(largest_difference(exact, difference(a, x, 1e-6)), 1e-6 * largest(exact));
}

/// A triangle of netting whose normal is at 60 degrees to x, in a flow or in free water.
Scene slanted_netting(std::array<double, 3> current, bool flows) {
  Sketch s;
  s.scene.current.samples = {{0, current}};
  const auto a = s.node(0, -2, -9), b = s.node(0, 2, -9), c = s.node(0, 2, -7), d = s.node(0, -2, -7);
  s.part("flow", "flow/momentum", {}, {a, b, b, c, c, d, d, a});
  const double x = 2 * std::sqrt(0.75);
  Part& net = s.part("net", "priour/triangle",
                     {{"twine.EA", 1e3}, {"twine.diameter", 0.002}, {"twine.density", 1000.0}},
                     {s.node(0, 0, -9), s.node(x, 1, -9), s.node(0, 0, -7)});
  net.laws["drag"] = {"hydro/loland", {}};
  net.data = {{"u", {0, 20, 0}}, {"v", {0, 0, 20}}, {"bar_length", {0.1}}};
  if (!flows) return s.scene;
  net.flow = 0;
  net.reach = {1};
  return s.scene;
}

// The water loses the fraction a along the current, and a cos 60° of what would pass through the netting.
TEST(ChangedWater, LetsMoreWaterThroughSlantedNetting) {
  constexpr double kInduced = 0.25, kCosine = 0.5;
  const double through = kSpeed * kCosine * (1 - kInduced * kCosine), along = kSpeed * (1 - kInduced),
               aside = (through - along * kCosine) / std::sqrt(0.75);
  Assembled slowed(slanted_netting({kSpeed, 0, 0}, true)),
      by_hand(slanted_netting({along, -aside, 0}, false));
  auto x = slowed.assembler.start();
  x[induction(slowed)] = kInduced;
  const auto drag_at = [](Assembled& a, const std::vector<double>& at, std::uint32_t node, int axis) {
    const auto drag = [](std::uint32_t t) { return (t & NETLOFT_IS_DRAG) != 0; };
    return a.assembler.reports().sum_terms(at, drag)[a.assembler.numbering().dof(node, axis).at()];
  };
  for (std::uint32_t node = 4; node < 7; ++node)
    for (int axis = 0; axis < 3; ++axis) {
      const double expected = drag_at(by_hand, by_hand.assembler.start(), node, axis);
      EXPECT_NEAR(drag_at(slowed, x, node, axis), expected, 1e-3 * std::abs(expected) + 1e-9) << axis;
    }
}

TEST(ChangedWater, IsTheSameForAnyNumberOfThreads) {
  Assembled one(bag_in_current()), two(bag_in_current(), 2);
  auto x = one.moved(0.1);
  EXPECT_EQ(one.residual(x), two.residual(x));
  EXPECT_EQ(one.matrix(x, MatrixKind::exact), two.matrix(x, MatrixKind::exact));
}

TEST(ChangedWater, LeavesTheUnknownAloneInStillWater) {
  const Assembled a(bag_in_current({}));
  EXPECT_FALSE(a.assembler.numbering().is_unknown(Dof(induction(a))));
  EXPECT_EQ(a.plan.unknowns, static_cast<std::size_t>(a.assembler.numbering().unknowns()));
}

TEST(ChangedWater, IsRefusedInAMotion) {
  try {
    make_scene_plan(bag_in_current(), plugins(), TangentChoice::exact, AnalysisKind::dynamics);
    FAIL();
  } catch (const SceneError& e) {
    EXPECT_EQ(e.faults[0].part, "flow");
    EXPECT_NE(e.faults[0].message.find("cannot be used in a motion"), std::string::npos);
  }
}

}  // namespace
}  // namespace netloft::test
