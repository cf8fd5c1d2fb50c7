// SPDX-License-Identifier: BSD-3-Clause
#include "io/gear/outline.hpp"

#include "io/gear/names.hpp"
#include "tests/unit/io/gear/plans.hpp"

#include <cmath>

namespace netloft::io {
namespace {

const OutlineEdge& edge(const Outline& outline, const std::string& name) {
  for (const auto& e : outline.edges)
    if (e.name == name) return e;
  ADD_FAILURE() << "no edge " << name;
  return outline.edges.front();
}

void expect_closed(const Outline& outline) {
  for (std::size_t i = 0; i < outline.edges.size(); ++i) {
    const auto &end = outline.edges[i].to, &next = outline.edges[(i + 1) % outline.edges.size()].from;
    EXPECT_NEAR(end.x, next.x, 1e-9);
    EXPECT_NEAR(end.y, next.y, 1e-9);
  }
}

TEST(Outline, OfAPairBeginsAtItsInnerSide) {
  const auto checked = check_text(kGoodPlan);
  const Outline outline = outline_of(*checked.plan.find_panel("wing"));
  expect_closed(outline);
  ASSERT_EQ(outline.edges.size(), 4u);
  EXPECT_DOUBLE_EQ(edge(outline, "outer").to.x, 10);
  EXPECT_DOUBLE_EQ(edge(outline, "outer").to.y, 20);
  EXPECT_DOUBLE_EQ(edge(outline, "inner").from.x, -20);
}

TEST(Outline, OfAMiddlePanelIsItsStarboardHalf) {
  const auto checked = check_text(kGoodPlan);
  const Outline outline = outline_of(*checked.plan.find_panel("body"));
  expect_closed(outline);
  EXPECT_DOUBLE_EQ(edge(outline, "bosom").to.x, 10);  // half of 20
  EXPECT_DOUBLE_EQ(edge(outline, "wing").to.x, 40);
  EXPECT_DOUBLE_EQ(edge(outline, "sides").to.x, 10);  // 40 less 42·2.5/3.5
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
  expect_closed(outline);
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

TEST(EdgeSet, CountsBothHalvesAcrossTheMiddle) {
  const auto checked = check_text(kGoodPlan);
  Diagnostics d;
  EXPECT_DOUBLE_EQ(find_edge(checked.plan, "body.fore", {}, "", d).meshes(), 80);
  EXPECT_DOUBLE_EQ(find_edge(checked.plan, "body.bosom", {}, "", d).meshes(), 20);
  const EdgeSet wing = find_edge(checked.plan, "body.wing", {}, "", d);
  EXPECT_DOUBLE_EQ(wing.meshes(), 30);
  EXPECT_EQ(wing.times(), 2);
  EXPECT_EQ(d.errors(), 0);
}

}  // namespace
}  // namespace netloft::io
