// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/outline.hpp"

#include "io/gears/plan/names.hpp"
#include "io/gears/plan/twine_coordinates.hpp"
#include "tests/unit/io/gears/plan/plans.hpp"

#include <cmath>
#include <numbers>

namespace netloft::gears {
namespace {

const OutlineEdge& edge(const Outline& outline, const std::string& name) {
  for (const auto& e : outline.edges)
    if (e.name == name) return e;
  ADD_FAILURE() << "no edge " << name;
  return outline.edges.front();
}

void expect_closed_outline(const Outline& outline) {
  for (std::size_t i = 0; i < outline.edges.size(); ++i) {
    const auto &end = outline.edges[i].to, &next = outline.edges[(i + 1) % outline.edges.size()].from;
    EXPECT_NEAR(end.x, next.x, 1e-9);
    EXPECT_NEAR(end.y, next.y, 1e-9);
  }
}

TEST(Outline, OfAPairBeginsAtItsInnerSide) {
  const auto checked = check_text(kGoodPlan);
  const Outline outline = outline_of(*checked.plan.find_panel("wing"));
  expect_closed_outline(outline);
  ASSERT_EQ(outline.edges.size(), 4u);
  EXPECT_DOUBLE_EQ(edge(outline, "outer").to.x, 10);
  EXPECT_DOUBLE_EQ(edge(outline, "outer").to.y, 20);
  EXPECT_DOUBLE_EQ(edge(outline, "inner").from.x, -20);
}

TEST(Outline, OfAMiddlePanelIsItsStarboardHalf) {
  const auto checked = check_text(kGoodPlan);
  const Outline outline = outline_of(*checked.plan.find_panel("body"));
  expect_closed_outline(outline);
  EXPECT_DOUBLE_EQ(edge(outline, "bosom").to.x, 10);  // half of 20 meshes
  EXPECT_DOUBLE_EQ(edge(outline, "wing").to.x, 40);
  EXPECT_DOUBLE_EQ(edge(outline, "sides").to.x, 10);  // 40 meshes less 42·2.5/3.5, by 5B1P over 42 deep
  EXPECT_DOUBLE_EQ(edge(outline, "middle").from.y, 42);
}

TEST(Outline, OfATriangleHasThreeCorners) {
  const auto checked = check_text(
      "[panels.wedge]\nstands = \"alone\"\nmesh = 0.1\ntwine = { diameter = 0.002, EA = 1, density = 1000 }\n"
      "fore = 0\ndepth = 10\naft = 10\nouter = \"AB out\"\ninner = \"AN\"\n");
  ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  EXPECT_EQ(outline_of(checked.plan.panels.front()).corners().size(), 3u);
}

TEST(Outline, KeepsTheCountsWhereCuttingsDiffer) {
  const auto checked = check_text(library_text("83-112-eastern.toml"));
  const Outline outline = outline_of(*checked.plan.find_panel("top-wing"));
  expect_closed_outline(outline);
  const auto& aft = edge(outline, "aft");
  EXPECT_NEAR(std::abs(aft.to.x - aft.from.x), 127.5, 1e-9);
  EXPECT_NEAR(edge(outline, "inner").stretched, 95.5 / 2.5 * 3.5, 1e-9);
}

TEST(Outline, CornersOfASideOfSeveralCutsLieBetweenThem) {
  const auto checked = check_text(library_text("83-112-eastern.toml"));
  const auto& wing = *checked.plan.find_panel("bottom-wing");
  const Outline outline = outline_of(wing);
  EXPECT_EQ(outline.corners().size(), 5u);
  EXPECT_NEAR(edge(outline, "breast-cut").to.y, 25.5, 1e-9);
  const auto corners = corner_names(wing);
  EXPECT_NE(std::find(corners.begin(), corners.end(), "breast-cut-aft"), corners.end());
}

/// Every change of counts and cuttings updates the stored outline: gathered selvedges, and rates that the
/// check replaces.
TEST(Outline, IsStoredAsItIsDrawn) {
  const auto expect_drawn = [](const NetPlan& plan) {
    for (const auto& panel : plan.panels) EXPECT_TRUE(panel.outline == outline_of(panel)) << panel.name;
  };
  expect_drawn(check_text(library_text("83-112-eastern.toml")).plan);
  std::string plan = library_text("83-112-eastern.toml");
  const std::string rate = "\"5B1P in\"";
  ASSERT_NE(plan.find(rate), std::string::npos);
  plan.replace(plan.find(rate), rate.size(), "\"5B1F in\"");
  const auto mended = check_text(plan);
  EXPECT_GT(mended.diagnostics.errors(), 0);
  expect_drawn(mended.plan);
}

/// The bag is sewn to a cover. The seams gather three meshes on each side of bag and cover, so that 14 of
/// their 20 meshes remain.
std::string laced_plan() {
  return kGoodPlan + R"(
[panels.cover]
mesh = "80 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960, mass = 0.003 }
twines = 2
fore = 20
depth = 50
sides = "AN"
[[join]]
edges = ["bag.sides", "cover.sides"]
selvedge = 3
)";
}

TEST(Selvedge, TakesItsMeshesOfThePanel) {
  const auto checked = check_text(laced_plan());
  const Outline outline = outline_of(*checked.plan.find_panel("cover"));
  EXPECT_TRUE(checked.plan.find_panel("cover")->outline == outline);
  expect_closed_outline(outline);
  EXPECT_DOUBLE_EQ(edge(outline, "fore").meshes, 7);
  EXPECT_DOUBLE_EQ(edge(outline, "sides").from.x, 7);
  EXPECT_DOUBLE_EQ(edge(outline, "sides").to.x, 7);
}

/// Three meshes have 6 twines, and 12 in double netting. The 50 meshes of 80 mm along the side are 4 m long.
TEST(Selvedge, IsAStripOfItsTwines) {
  const auto checked = check_text(laced_plan());
  const Rope* rope = checked.plan.find_rope("cover-sides-selvedge");
  ASSERT_TRUE(rope) << checked.said();
  EXPECT_DOUBLE_EQ(rope->length, 4);
  EXPECT_EQ(rope->stands, Standing::pair);
  const auto number = [&](const char* key) {
    return *rope->rope.as<formats::Table>()->find(key)->value.as<double>();
  };
  EXPECT_DOUBLE_EQ(number("EA"), 12 * 3000.0);
  EXPECT_DOUBLE_EQ(number("mass"), 12 * 0.003);
  EXPECT_DOUBLE_EQ(number("diameter"), std::sqrt(12.0) * 0.002);
}

/// The seams make the bag narrower, so its fore edge no longer fits the 20 meshes of the body.
TEST(Selvedge, ChangesWhatIsSewnBesideIt) {
  const auto checked = check_text(laced_plan());
  EXPECT_NE(checked.said().find("body.aft has 20 meshes, but bag.fore has 14 meshes"), std::string::npos)
      << checked.said();
}

TEST(Selvedge, OfARibRopeIsAllowed) {
  const auto checked = check_text(laced_plan() + R"(
[ropes.rib]
rope = { diameter = "12 mm", EA = "100 kN", density = 1000 }
length = "4 m"
[[hang]]
edge = "bag.sides"
on = "rib"
length = "3.9 m"
)");
  EXPECT_EQ(checked.said().find("hung twice"), std::string::npos) << checked.said();
}

Outline turned(const std::string& keys) {
  const auto checked = check_text(
      "[panels.sheet]\nstands = \"alone\"\nmesh = 0.1\ntwine = { diameter = 0.002, EA = 1, density = 1000 }\n"
      "fore = 10\ndepth = 10\nouter = \"1N2B out\"\ninner = \"AN\"\n" +
      keys);
  EXPECT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  return outline_of(checked.plan.panels.front());
}

/// A stretched mesh has two bars. In diamond and T90 netting, counts are meshes; in square netting, they are
/// bars.
TEST(Outline, SquareNettingIsHalfAsLongWhenStretched) {
  EXPECT_DOUBLE_EQ(edge(turned(""), "fore").stretched, 10);
  EXPECT_DOUBLE_EQ(edge(turned("orientation = \"t90\"\n"), "fore").stretched, 10);
  EXPECT_DOUBLE_EQ(edge(turned("orientation = \"square\"\n"), "fore").stretched, 5);
}

/// Computed by hand: a cycle of 1N2B is 2 meshes deep and has 2 bars and a point, which is 2 bars long. The 5
/// cycles over a depth of 10 meshes have 20 bars, the length of 10 stretched meshes.
TEST(Outline, TwinesAlongACutAreThoseOfItsBarsAndPoints) {
  EXPECT_DOUBLE_EQ(edge(turned(""), "outer").stretched, 5 * (2 * 0.5 + 1));
}

/// Netting turned by 45° has straight rows of bars along its edges. Each of the 10 meshes of an edge holds √2
/// bars, and a stretched mesh has two bars, so that the edge is 10/√2 stretched meshes long.
TEST(Outline, NettingTurnedByAnEighthRunsAlongItsBars) {
  EXPECT_NEAR(edge(turned("angle = \"45 deg\"\n"), "fore").stretched, 10 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(edge(turned("angle = \"90 deg\"\n"), "fore").stretched, 10, 1e-12);
}

TEST(TwineCoordinates, OfDiamondTurnedByAnEighthAreThoseOfSquareNetting) {
  const auto turned = twine_coordinates("diamond", std::numbers::pi / 4, 2, 5);
  const auto square = twine_coordinates("square", 0, 2, 5);
  EXPECT_NEAR(turned[0], std::sqrt(2.0) * square[1], 1e-12);
  EXPECT_NEAR(turned[1], -std::sqrt(2.0) * square[0], 1e-12);
}

/// Turned by a right angle, diamond netting is T90 with the names of its twines exchanged.
TEST(TwineCoordinates, OfDiamondTurnedByARightAngleAreThoseOfT90) {
  const auto turned = twine_coordinates("diamond", std::numbers::pi / 2, 2, 5);
  const auto t90 = twine_coordinates("t90", 0, 2, 5);
  EXPECT_NEAR(turned[0], -t90[1], 1e-12);
  EXPECT_NEAR(turned[1], -t90[0], 1e-12);
}

/// A rotation does not change u² + v².
TEST(TwineCoordinates, TurningIsARotation) {
  for (const char* orientation : {"diamond", "t90", "square"}) {
    const auto plain = twine_coordinates(orientation, 0, 2, 5),
               turned = twine_coordinates(orientation, 0.7, 2, 5);
    EXPECT_NEAR(std::hypot(turned[0], turned[1]), std::hypot(plain[0], plain[1]), 1e-12);
  }
}

TEST(EdgeSet, CountsBothHalvesAcrossTheMiddle) {
  const auto checked = check_text(kGoodPlan);
  formats::Diagnostics d;
  EXPECT_DOUBLE_EQ(find_edge(checked.plan, "body.fore", {}, "", d).meshes(), 80);
  EXPECT_DOUBLE_EQ(find_edge(checked.plan, "body.bosom", {}, "", d).meshes(), 20);
  const EdgeSet wing = find_edge(checked.plan, "body.wing", {}, "", d);
  EXPECT_DOUBLE_EQ(wing.meshes(), 30);
  EXPECT_EQ(wing.times(), 2);
  EXPECT_EQ(d.errors(), 0);
}

}  // namespace
}  // namespace netloft::gears
