// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/gear.hpp"

#include "tests/unit/io/gears/plan/plans.hpp"

#include <cmath>
#include <set>

namespace netloft::gears {
namespace {

std::vector<std::string> names(const Gear& gear, const std::vector<EdgeRef>& row) {
  std::vector<std::string> all;
  for (const auto& ref : row) all.push_back(gear.name_of(ref));
  return all;
}

void expect_closed(const Outline& outline) {
  for (std::size_t i = 0; i < outline.edges.size(); ++i) {
    const auto &end = outline.edges[i].to, &next = outline.edges[(i + 1) % outline.edges.size()].from;
    EXPECT_NEAR(std::hypot(end.x - next.x, end.y - next.y), 0, 1e-9) << outline.edges[i].name;
  }
}

double total(const std::vector<HungEdge>& hung) {
  double sum = 0;
  for (const auto& h : hung) sum += h.length;
  return sum;
}

using Names = std::vector<std::string>;

TEST(Gear, TheWholeHasPairsTwice) {
  const auto checked = check_text(kGoodPlan);
  const Gear gear = make_gear(checked.plan, Extent::whole);
  EXPECT_EQ(gear.panels.size(), 4u);
  ASSERT_TRUE(gear.find_panel("port-wing"));
  EXPECT_TRUE(gear.find_panel("port-wing")->is_mirrored);
  EXPECT_FALSE(gear.find_panel("starboard-wing")->is_mirrored);
  EXPECT_TRUE(gear.find_panel("body"));
}

TEST(Gear, TheHalfHasEveryPanelOnceByItsOwnName) {
  const auto checked = check_text(kGoodPlan);
  const Gear gear = make_gear(checked.plan, Extent::half);
  EXPECT_EQ(gear.panels.size(), 3u);
  EXPECT_TRUE(gear.find_panel("wing"));
}

TEST(Gear, OutlinesAreClosed) {
  for (const auto& text : {kGoodPlan, library_text("83-112-eastern.toml")})
    for (const Extent extent : {Extent::whole, Extent::half}) {
      const auto checked = check_text(text);
      for (const auto& panel : make_gear(checked.plan, extent).panels) expect_closed(panel.outline);
    }
}

TEST(Gear, EdgesInTheMiddleAreWholeAndOthersAreToPortAndToStarboard) {
  const auto checked = check_text(kGoodPlan);
  const Gear gear = make_gear(checked.plan, Extent::whole);
  std::set<std::string> edges;
  for (const auto& edge : gear.find_panel("body")->outline.edges) {
    edges.insert(edge.name);
    if (edge.name == "bosom") {
      EXPECT_DOUBLE_EQ(edge.meshes, 20);
      EXPECT_DOUBLE_EQ(edge.from.x, -10);
      EXPECT_DOUBLE_EQ(edge.to.x, 10);
    }
  }
  EXPECT_EQ(edges, (std::set<std::string>{"bosom", "starboard-wing", "port-wing", "starboard-sides",
                                          "port-sides", "aft"}));
}

TEST(Gear, SeamsOfPairsAreSewnOnBothSides) {
  const auto checked = check_text(kGoodPlan);
  const Gear gear = make_gear(checked.plan, Extent::whole);
  ASSERT_EQ(gear.seams.size(), 3u);
  EXPECT_EQ(names(gear, gear.seams[0].edges[0]), Names{"starboard-wing.aft"});
  EXPECT_EQ(names(gear, gear.seams[0].edges[1]), Names{"body.starboard-wing"});
  EXPECT_EQ(names(gear, gear.seams[1].edges[0]), Names{"port-wing.aft"});
  EXPECT_EQ(names(gear, gear.seams[1].edges[1]), Names{"body.port-wing"});
  EXPECT_EQ(names(gear, gear.seams[2].edges[1]), Names{"bag.fore"});
}

TEST(Gear, EdgesInARowStayInTheirOrder) {
  const auto checked = check_text(library_text("83-112-eastern.toml"));
  const Gear gear = make_gear(checked.plan, Extent::half);
  EXPECT_EQ(names(gear, gear.seams[2].edges[0]), (Names{"top-wing.side", "top-body.sides"}));
}

TEST(Gear, ARopeOfTheMiddleRunsFromPortToStarboard) {
  const auto checked = check_text(kGoodPlan);
  const Gear gear = make_gear(checked.plan, Extent::whole);
  const GearRope& rope = *gear.find_rope("headline");
  std::vector<EdgeRef> row;
  for (const auto& hung : rope.hung) row.push_back(hung.edge);
  EXPECT_EQ(names(gear, row), (Names{"port-wing.inner", "body.bosom", "starboard-wing.inner"}));
  EXPECT_DOUBLE_EQ(rope.length, 6);
  EXPECT_DOUBLE_EQ(total(rope.hung), 1 + 2 * 1.9);  // half of 20 meshes of 0.1 m, and both wings
}

TEST(Gear, HalfOfItHasHalfOfTheRope) {
  const auto checked = check_text(kGoodPlan);
  const Gear gear = make_gear(checked.plan, Extent::half);
  EXPECT_DOUBLE_EQ(gear.find_rope("headline")->length, 3);
  EXPECT_DOUBLE_EQ(total(gear.find_rope("headline")->hung), 0.5 + 1.9);
  EXPECT_DOUBLE_EQ(gear.find_rope("bridle")->length, 20);
}

TEST(Gear, BridlesEndAtTheirOwnSide) {
  const auto checked = check_text(kGoodPlan);
  const Gear gear = make_gear(checked.plan, Extent::whole);
  EXPECT_EQ(gear.find_rope("port-bridle")->between,
            (std::array<std::string, 2>{"port-door", "headline.start"}));
  EXPECT_EQ(gear.find_rope("starboard-bridle")->between,
            (std::array<std::string, 2>{"starboard-door", "headline.end"}));
}

const GearPieces& pieces(const Gear& gear, const std::string& name) {
  for (const auto& one : gear.pieces)
    if (one.name == name) return one;
  ADD_FAILURE() << "no pieces " << name;
  return gear.pieces.front();
}

const GearPoint& point(const Gear& gear, const std::string& name) {
  for (const auto& one : gear.points)
    if (one.name == name) return one;
  ADD_FAILURE() << "no point " << name;
  return gear.points.front();
}

TEST(Gear, TheHalfHasHalfOfTheFloatsOfTheMiddle) {
  const auto checked = check_text(kGoodPlan);
  EXPECT_DOUBLE_EQ(pieces(make_gear(checked.plan, Extent::whole), "top").number, 11);
  const Gear half = make_gear(checked.plan, Extent::half);
  EXPECT_DOUBLE_EQ(pieces(half, "top").number, 5.5);
  EXPECT_EQ(pieces(half, "top").rope, "headline");
}

TEST(Gear, PiecesOfAPairAreSharedOutBetweenBothSides) {
  for (const std::string place :
       {"along wing.inner", "along bridle", "at wing.fore-outer", "at headline.end"}) {
    const auto checked = check_text(changed_plan("11 along headline", "11 " + place));
    ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
    const Gear whole = make_gear(checked.plan, Extent::whole), half = make_gear(checked.plan, Extent::half);
    ASSERT_EQ(whole.pieces.size(), 2u) << place;
    EXPECT_DOUBLE_EQ(pieces(whole, "port-top").number, 5.5);
    EXPECT_DOUBLE_EQ(pieces(half, "top").number, 5.5);
  }
}

TEST(Gear, HasAsManyPiecesAsTheKeyNumberSays) {
  for (const std::string spread : {"11 along headline", "along headline"}) {
    const auto checked =
        check_text(changed_plan("\"11 along headline\"", "\"" + spread + "\"\nnumber = 7.5"));
    ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
    EXPECT_NE(checked.said().find("floats.top.number: 7.5 pieces can be computed but not rigged"),
              std::string::npos)
        << checked.said();
    EXPECT_DOUBLE_EQ(pieces(make_gear(checked.plan, Extent::whole), "top").number, 7.5);
    EXPECT_EQ(checked.said().find("7.5 pieces, not the 11 in spread") != std::string::npos, spread[0] == '1');
  }
  for (const std::string wrong :
       {"\"along headline\"", "\"11 along headline\"\nnumber = 0", "\"along headline\"\nnumber = -3"})
    EXPECT_GT(check_text(changed_plan("\"11 along headline\"", wrong)).diagnostics.errors(), 0) << wrong;
}

TEST(Gear, PiecesStandOnTheirOwnSide) {
  const auto edges = check_text(changed_plan("11 along headline", "11 along wing.inner"));
  const Gear gear = make_gear(edges.plan, Extent::whole);
  EXPECT_EQ(names(gear, pieces(gear, "port-top").edges), Names{"port-wing.inner"});
  const auto ends = check_text(changed_plan("11 along headline", "2 at headline.end"));
  EXPECT_EQ(pieces(make_gear(ends.plan, Extent::whole), "port-top").point, "headline.start");
  const auto corners = check_text(changed_plan("11 along headline", "2 at body.aft-outer"));
  EXPECT_EQ(pieces(make_gear(corners.plan, Extent::whole), "port-top").point, "body.port-aft-outer");
}

TEST(Gear, WhatLiesOnThePlaneOfSymmetryIsThereOnce) {
  const auto checked = check_text(changed_plan("11 along headline", "3 at headline.middle"));
  const Gear whole = make_gear(checked.plan, Extent::whole), half = make_gear(checked.plan, Extent::half);
  ASSERT_EQ(whole.pieces.size(), 1u);
  EXPECT_EQ(whole.pieces[0].point, "headline.middle");
  EXPECT_DOUBLE_EQ(whole.pieces[0].number, 3);
  EXPECT_EQ(half.pieces[0].point, "headline.start");
  EXPECT_DOUBLE_EQ(half.pieces[0].number, 1.5);
}

TEST(Gear, PointsToPortAreMirrored) {
  const auto checked = check_text(changed_plan("[points.door]", "[points.door]\nat = [-20, 15, 1]"));
  ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  const Gear gear = make_gear(checked.plan, Extent::whole);
  EXPECT_EQ(point(gear, "port-door").at, (std::array<double, 3>{-20, -15, 1}));
  EXPECT_EQ(point(gear, "starboard-door").at, (std::array<double, 3>{-20, 15, 1}));
}

TEST(Gear, ARopeOfTheMiddleIsTiedOnBothSides) {
  const std::string headline = "stands = \"middle\"\n";
  const auto checked = check_text(changed_plan(headline, headline + "between = [\"kite\", \"post\"]\n") +
                                  "[points.kite]\nstands = \"middle\"\n[points.post]\n");
  ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  const GearRope rope = *make_gear(checked.plan, Extent::whole).find_rope("headline");
  EXPECT_EQ(rope.between, (std::array<std::string, 2>{"port-post", "starboard-post"}));
  EXPECT_EQ(rope.middle, "kite");
  const GearRope half = *make_gear(checked.plan, Extent::half).find_rope("headline");
  EXPECT_EQ(half.between, (std::array<std::string, 2>{"kite", "post"}));
}

/// The corners of the panel are at the corners of its sketch, its sides are straight, and its port half is
/// the mirror image.
TEST(Gear, ASketchPutsAPanelInItsPlace) {
  const auto checked = check_text(changed_plan(
      "sides = \"5B1P in\"", "sides = \"5B1P in\"\nsketch = [[0, 0, 2], [0, 3, 2], [4, 1, 1], [4, 0, 1]]"));
  ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  const Gear gear = make_gear(checked.plan, Extent::whole);
  const GearPanel& body = *gear.find_panel("body");
  ASSERT_TRUE(body.has_sketch());
  const auto expect_at = [&](PanelPoint p, std::array<double, 3> at) {
    const auto found = body.sketched(p);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], at[k], 1e-12) << p.x << ", " << p.y;
  };
  expect_at({40, 0}, {0, 3, 2}), expect_at({-40, 0}, {0, -3, 2});
  expect_at({10, 42}, {4, 1, 1}), expect_at({-10, 42}, {4, -1, 1});
  expect_at({0, 21}, {2, 0, 1.5}), expect_at({20, 0}, {0, 1.5, 2});
}

/// A cod-end made of one sheet, 20 meshes round; half of the gear has 10 of them.
std::string tube_plan() {
  return changed_plan("fore = 20\ndepth = 50\nsides = \"AN\"\nopen = [\"sides\", \"aft\"]",
                      "round = 20\ndepth = 25\npieces = 2\nopen = \"aft\"");
}

TEST(Gear, ATubeIsSewnToItself) {
  const auto checked = check_text(tube_plan());
  ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  const Gear gear = make_gear(checked.plan, Extent::whole);
  ASSERT_EQ(gear.seams.size(), 4u);
  EXPECT_EQ(names(gear, gear.seams[3].edges[0]), Names{"bag.starboard-sides"});
  EXPECT_EQ(names(gear, gear.seams[3].edges[1]), Names{"bag.port-sides"});
}

TEST(Gear, HalfOfATubeLiesOnThePlaneWithBothSides) {
  const auto checked = check_text(tube_plan());
  const Gear gear = make_gear(checked.plan, Extent::half);
  EXPECT_EQ(gear.seams.size(), 2u);
  int on_plane = 0;
  for (const auto& edge : gear.find_panel("bag")->outline.edges) {
    on_plane += edge.kind == EdgeKind::middle || edge.is_on_plane;
    if (edge.kind == EdgeKind::fore) {
      EXPECT_DOUBLE_EQ(edge.meshes, 10);
    }
  }
  EXPECT_EQ(on_plane, 2);
}

TEST(Gear, PairsMayBeSewnTogetherInTheMiddle) {
  const auto checked = check_text(changed_plan("open = [\"fore\", \"outer\"]", "open = \"fore\"") +
                                  "[[join]]\nedges = [\"wing.outer\", \"wing.outer\"]\n");
  ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  const Gear gear = make_gear(checked.plan, Extent::whole);
  EXPECT_EQ(names(gear, gear.seams[3].edges[0]), Names{"starboard-wing.outer"});
  EXPECT_EQ(names(gear, gear.seams[3].edges[1]), Names{"port-wing.outer"});
}

TEST(Gear, PiecesInARowAreOnePanel) {
  const auto checked = check_text(tube_plan());
  EXPECT_DOUBLE_EQ(checked.plan.find_panel("bag")->depth, 50);
}

TEST(Gear, TheWholeHasTwiceTheAreaOfTheHalf) {
  const auto checked = check_text(library_text("83-112-eastern.toml"));
  const auto area = [&](Extent extent) {
    double sum = 0;
    for (const auto& panel : make_gear(checked.plan, extent).panels)
      for (const auto& e : panel.outline.edges) sum += 0.5 * (e.from.x * e.to.y - e.to.x * e.from.y);
    return sum;
  };
  EXPECT_NEAR(area(Extent::whole), 2 * area(Extent::half), 1e-9 * area(Extent::whole));
  EXPECT_GT(area(Extent::half), 0);
}

/// The name "fore" of a middle panel means all parts of its fore edge: in the middle, to port and to
/// starboard.
TEST(Gear, ANameForSeveralStretchesHoldsThoseToPort) {
  const auto checked = check_text(R"(
[panels.square]
mesh = "100 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960 }
fore = 80
depth = 20
sides = "AN"
[panels.body]
mesh = "100 mm"
twine = { diameter = "2 mm", EA = "3 kN", density = 960 }
fore = [{ name = "bosom", meshes = 20 }, { name = "wing", meshes = 30 }]
depth = 42
aft = 20
sides = "5B1P in"
[ropes.rib]
stands = "middle"
rope = { diameter = "12 mm", EA = "100 kN", density = 1000 }
length = "4 m"
[[join]]
edges = ["square.aft", "body.fore"]
[[hang]]
edge = "body.fore"
on = "rib"
length = "4 m"
)");
  ASSERT_EQ(checked.diagnostics.errors(), 0u) << checked.said();
  const Gear gear = make_gear(checked.plan, Extent::whole);
  const Names row = {"body.port-wing", "body.bosom", "body.starboard-wing"};
  EXPECT_EQ(names(gear, gear.seams[0].edges[1]), row);
  std::vector<EdgeRef> hung;
  for (const auto& h : gear.ropes[0].hung) hung.push_back(h.edge);
  EXPECT_EQ(names(gear, hung), row);
  EXPECT_NEAR(gear.ropes[0].hung[1].length, 1, 1e-12);  // 20 of 80 meshes
  EXPECT_NEAR(total(gear.ropes[0].hung), 4, 1e-12);
}

}  // namespace
}  // namespace netloft::gears
