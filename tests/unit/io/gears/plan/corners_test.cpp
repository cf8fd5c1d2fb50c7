// SPDX-License-Identifier: BSD-3-Clause
//
// Panels defined by the panel coordinates of their corners [meshes].
#include "tests/unit/io/gears/plan/divided.hpp"
#include "tests/unit/io/gears/plan/plans.hpp"

#include <cmath>

namespace netloft::gears {
namespace {

constexpr double kPi = 3.141592653589793;
const std::string kTwine =
    "mesh = \"100 mm\"\ntwine = { diameter = \"2 mm\", EA = \"3 kN\", density = 960 }\n";

std::string panel(const std::string& stands, const std::string& shape, const std::string& open) {
  return "[panels.net]\nstands = \"" + stands + "\"\n" + kTwine + shape + "\nopen = " + open + "\n";
}

GearMesh divided(const Gear& gear) {
  Fineness fineness;
  fineness.nodes = 300;
  return divide(gear, fineness);
}

/// Expects that both outlines have the same edges in the same places.
void expect_same(const Outline& a, const Outline& b) {
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    EXPECT_EQ(a.edges[i].name, b.edges[i].name);
    EXPECT_EQ(a.edges[i].kind, b.edges[i].kind) << a.edges[i].name;
    EXPECT_NEAR(a.edges[i].from.x, b.edges[i].from.x, 1e-9) << a.edges[i].name;
    EXPECT_NEAR(a.edges[i].from.y, b.edges[i].from.y, 1e-9) << a.edges[i].name;
    EXPECT_NEAR(a.edges[i].meshes, b.edges[i].meshes, 1e-9) << a.edges[i].name;
    EXPECT_NEAR(a.edges[i].stretched, b.edges[i].stretched, 1e-9) << a.edges[i].name;
  }
}

TEST(Corners, MakeThePanelThatCountsAndCuttingsMake) {
  const struct {
    const char *stands, *counts, *corners, *open;
  } same[] = {
      {"pair", "fore = 10\ndepth = 20\naft = 30\nouter = \"AN\"\ninner = \"AB out\"",
       "corners = [[0, 0], [10, 0], [10, 20], [-20, 20]]", "[\"fore\", \"outer\", \"aft\", \"inner\"]"},
      {"pair", "fore = 10\ndepth = 20\naft = 30\nouter = \"AN\"\ninner = \"AB out\"",
       "corners = [[-17, 23], [13, 23], [13, 3], [3, 3]]", "[\"fore\", \"outer\", \"aft\", \"inner\"]"},
      {"middle",
       "fore = [{ name = \"bosom\", meshes = 20 }, { name = \"wing\", meshes = 30 }]\ndepth = 42\naft = 20\n"
       "sides = \"5B1P in\"",
       "corners = [[0, 0], [10, 0], [40, 0], [10, 42], [0, 42]]\n"
       "edges = [\"bosom\", \"wing\", \"sides\", \"aft\", \"middle\"]",
       "[\"fore\", \"sides\", \"aft\"]"},
      {"alone", "fore = 0\ndepth = 10\naft = 10\nouter = \"AB out\"\ninner = \"AN\"",
       "corners = [[10, 10], [0, 10], [0, 0]]", "[\"outer\", \"aft\", \"inner\"]"},
  };
  for (const auto& s : same) {
    const auto counted = check_text(panel(s.stands, s.counts, s.open)),
               cornered = check_text(panel(s.stands, s.corners, s.open));
    ASSERT_EQ(cornered.diagnostics.errors(), 0) << cornered.said();
    expect_same(outline_of(counted.plan.panels[0]), outline_of(cornered.plan.panels[0]));
  }
}

TEST(Corners, MakeAPanelOfAnyNumberOfSides) {
  for (int n = 3; n <= 24; ++n) {
    std::string corners;
    for (int k = 0; k < n; ++k)
      corners += (k ? ", [" : "[") + std::to_string(20 * std::cos(0.1 + 2 * kPi * k / n)) + ", " +
                 std::to_string(15 * std::sin(0.1 + 2 * kPi * k / n)) + "]";
    const auto checked = check_text(panel("alone", "corners = [" + corners + "]", "[]"));
    ASSERT_EQ(checked.diagnostics.errors(), 0) << n << checked.said();
    const double area = 0.5 * n * 20 * 15 * std::sin(2 * kPi / n);
    EXPECT_NEAR(outline_area(outline_of(checked.plan.panels[0])), area, 1e-3)
        << n;  // corners in the plan have six decimals
    const Gear gear = make_gear(checked.plan, Extent::whole);
    const GearMesh mesh = divided(gear);
    expect_areas(gear, mesh);
    expect_closed_and_oriented(gear, mesh);
  }
}

TEST(Corners, OfAPanelInTheMiddleAreThoseToStarboard) {
  const auto checked =
      check_text(panel("middle", "corners = [[0, 3], [8, 0], [12, 0], [20, 14], [9, 30], [0, 30]]", "[]"));
  EXPECT_NE(checked.said().find("do not begin and end in the middle"), std::string::npos) << checked.said();
  const auto fine =
      check_text(panel("middle", "corners = [[0, 0], [12, 0], [20, 14], [9, 30], [0, 30]]", "[]"));
  ASSERT_EQ(fine.diagnostics.errors(), 0) << fine.said();
  const Gear gear = make_gear(fine.plan, Extent::whole);
  EXPECT_NEAR(outline_area(gear.panels[0].outline), 2 * (14 * 16 + 16 * 14.5), 1e-9);
  expect_areas(gear, divided(gear));
}

TEST(Corners, HaveEdgesThatAreSewnAndHungByName) {
  const std::string plan =
      panel("alone",
            "corners = [[0, 0], [20, 0], [26, 9], [15, 24], [5, 24]]\nedges = [\"top\", \"cut\", \"flap\", "
            "\"end\", \"port\"]",
            "[\"cut\", \"end\", \"port\"]") +
      "[panels.flap]\nstands = \"alone\"\n" + kTwine +
      "corners = [[0, 0], [15, 0], [15, 8], [0, 8]]\nopen = [\"outer\", \"aft\", \"inner\"]\n" +
      "[ropes.line]\nstands = \"alone\"\nrope = { diameter = \"12 mm\", EA = \"100 kN\", density = 1000 }\n"
      "length = \"1.2 m\"\n[[hang]]\nedge = \"net.top\"\non = \"line\"\nlength = \"1.2 m\"\n"
      "[[join]]\nedges = [\"net.flap\", \"flap.fore\"]\n";
  const auto checked = check_text(plan);
  ASSERT_EQ(checked.diagnostics.errors(), 0) << checked.said();
  const Gear gear = make_gear(checked.plan, Extent::whole);
  const GearMesh mesh = divided(gear);
  expect_closed_and_oriented(gear, mesh);
  EXPECT_GT(mesh.panels[0].sets.at("flap").size(), 2u);
}

TEST(Corners, ThatAreWrongAreAnsweredWithPlaceAndCure) {
  const struct {
    const char *shape, *says;
  } wrong[] = {
      {"corners = [[0, 0], [10, 0]]", "corners"},
      {"corners = [[0, 0], [10, 0], [10, 5, 3]]", "corners"},
      {"corners = [[0, 0], [10, 0], [1e9, 5]]", "corners"},
      {"corners = [[0, 0], [10, 0], [20, 0]]", "enclose no netting"},
      {"corners = [[0, 0], [10, 0], [10, 0], [5, 8]]", "corners 2 and 3 are in one place"},
      {"corners = [[0, 0], [10, 0], [10, 10], [6, 3], [0, 10]]", "turn back at [6, 3]"},
      {"corners = [[0, 0], [10, 0], [5, 8]]\ndepth = 8", "depth: follows from the corners"},
      {"corners = [[0, 0], [10, 0], [5, 8]]\nsides = \"AN\"", "sides: follows from the corners"},
      {"corners = [[0, 0], [10, 0], [5, 8]]\nedges = [\"a\"]", "edges"},
      {"corners = [[0, 0], [10, 0], [5, 8]]\nedges = [\"a\", \"a\", \"b\"]",
       "two of its edges are named \"a\""},
      {"corners = 3", "corners"},
      {"edges = [\"a\", \"b\", \"c\"]\nfore = 3\ndepth = 9\nouter = \"AN\"\ninner = \"AN\"",
       "unknown key \"edges\""},
  };
  for (const auto& w : wrong) {
    const auto checked = check_text(panel("alone", w.shape, "[]"));
    EXPECT_GE(checked.diagnostics.errors(), 1) << w.shape;
    EXPECT_NE(checked.said().find(w.says), std::string::npos) << w.shape << "\n" << checked.said();
  }
}

}  // namespace
}  // namespace netloft::gears
