// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/geometry.hpp"

#include <cmath>

#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::scenes {
namespace {

using formats::test::Input;
using Nodes = std::vector<std::uint32_t>;

/// The keys of a panel of 4 x 3 meshes in 2 x 2 cells, drawn as a horizontal unit square.
constexpr const char* kPanel =
    "panel = { across = 4, along = 3, bar = 0.1 }\ncells = [2, 2]\n"
    "sketch = [[0, 0, 0], [2, 0, 0], [2, 0, -4], [0, 0, -4]]\n";

Geometry panel(const std::string& text = kPanel) {
  Input in(text);
  Geometry g = read_panel(in.reader);
  EXPECT_EQ(in.diagnostics.render(false), "");
  return g;
}

Geometry rope(const std::string& text) {
  Input in(text);
  Geometry g = read_line(in.reader);
  EXPECT_EQ(in.diagnostics.render(false), "");
  return g;
}

std::array<double, 3> at(const Geometry& g, std::size_t node) {
  return {g.positions[3 * node], g.positions[3 * node + 1], g.positions[3 * node + 2]};
}

Nodes triangle(const Geometry& g, std::size_t t) {
  return {g.elements[3 * t], g.elements[3 * t + 1], g.elements[3 * t + 2]};
}

TEST(Panel, NumbersNodesRowByRowFromTheForeEdge) {
  const Geometry g = panel();
  ASSERT_EQ(g.node_count(), 9u);
  EXPECT_EQ(at(g, 0), (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(at(g, 1), (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(at(g, 2), (std::array<double, 3>{2, 0, 0}));
  EXPECT_EQ(at(g, 3), (std::array<double, 3>{0, 0, -2}));
  EXPECT_EQ(at(g, 8), (std::array<double, 3>{2, 0, -4}));
}

TEST(Panel, NamesEdgesInTheOrderOfTheirNodes) {
  const auto sets = panel().names.sets;
  EXPECT_EQ(sets.at("fore"), (Nodes{0, 1, 2}));
  EXPECT_EQ(sets.at("aft"), (Nodes{6, 7, 8}));
  EXPECT_EQ(sets.at("left"), (Nodes{0, 3, 6}));
  EXPECT_EQ(sets.at("right"), (Nodes{2, 5, 8}));
}

TEST(Panel, NamesCorners) {
  const auto sets = panel().names.sets;
  EXPECT_EQ(sets.at("fore-left"), Nodes{0});
  EXPECT_EQ(sets.at("fore-right"), Nodes{2});
  EXPECT_EQ(sets.at("aft-left"), Nodes{6});
  EXPECT_EQ(sets.at("aft-right"), Nodes{8});
}

TEST(Panel, AlternatesDiagonalsFromTheFirstCellOn) {
  const Geometry g = panel();
  ASSERT_EQ(g.elements.size(), 3u * 8);
  EXPECT_EQ(triangle(g, 0), (Nodes{0, 1, 4}));  // cell (0, 0): diagonal 0-4
  EXPECT_EQ(triangle(g, 1), (Nodes{0, 4, 3}));
  EXPECT_EQ(triangle(g, 2), (Nodes{1, 2, 4}));  // cell (1, 0): diagonal 2-4
  EXPECT_EQ(triangle(g, 3), (Nodes{2, 5, 4}));
  EXPECT_EQ(triangle(g, 4), (Nodes{3, 4, 6}));  // cell (0, 1): diagonal 4-6
  EXPECT_EQ(triangle(g, 5), (Nodes{4, 7, 6}));
  EXPECT_EQ(triangle(g, 6), (Nodes{4, 5, 8}));  // cell (1, 1): diagonal 4-8
  EXPECT_EQ(triangle(g, 7), (Nodes{4, 8, 7}));
}

std::string crossed() { return std::string(kPanel) + "division = \"crossed\"\n"; }

TEST(CrossedPanel, HasFourTrianglesAboutTheMiddleOfEachCell) {
  const Geometry g = panel(crossed());
  ASSERT_EQ(g.node_count(), 9u + 4);
  EXPECT_EQ(at(g, 9), (std::array<double, 3>{0.5, 0, -1}));
  EXPECT_EQ(g.names.panel[12], (std::array<double, 2>{3, 2.25}));
  ASSERT_EQ(g.elements.size(), 3u * 16);
  EXPECT_EQ(triangle(g, 0), (Nodes{0, 1, 9}));
  EXPECT_EQ(triangle(g, 1), (Nodes{1, 4, 9}));
  EXPECT_EQ(triangle(g, 2), (Nodes{4, 3, 9}));
  EXPECT_EQ(triangle(g, 3), (Nodes{3, 0, 9}));
}

TEST(CrossedPanel, HasTheEdgesOfThePanelThatAlternates) {
  EXPECT_EQ(panel(crossed()).names.sets, panel().names.sets);
}

/// Meshes are counted from the aft edge; with crossed cells, the last node is the centre of a cell and not on
/// that edge.
TEST(CrossedPanel, CountsMeshesToTheAftEdge) {
  const Geometry g = panel(crossed());
  const auto& to_aft = g.data.at("to_aft");
  EXPECT_EQ((std::vector<double>{to_aft[0], to_aft[1], to_aft[2]}), (std::vector<double>{3, 3, 2.25}));
}

TEST(CrossedPanel, KnowsNoOtherDivision) {
  Input in(std::string(kPanel) + "division = \"criss-cross\"\n");
  read_panel(in.reader);
  const std::string said = in.diagnostics.render(false);
  EXPECT_NE(said.find("criss-cross"), std::string::npos);
  EXPECT_NE(said.find("crossed"), std::string::npos);
}

TEST(Panel, TurnsAllTrianglesTheSameWay) {
  const Geometry g = panel();
  for (std::size_t t = 0; t < 8; ++t) {
    const auto n = triangle(g, t);
    const auto a = at(g, n[0]), b = at(g, n[1]), c = at(g, n[2]);
    EXPECT_LT((b[0] - a[0]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[0] - a[0]), 0) << t;
  }
}

TEST(Panel, GivesPanelCoordinatesInMeshes) {
  const auto& UV = panel().names.panel;
  EXPECT_EQ(UV[0], (std::array<double, 2>{0, 0}));
  EXPECT_EQ(UV[2], (std::array<double, 2>{4, 0}));
  EXPECT_EQ(UV[4], (std::array<double, 2>{2, 1.5}));
  EXPECT_EQ(UV[8], (std::array<double, 2>{4, 3}));
}

/// A mesh across is one bar along u and one back along v: u = U + V, v = V - U (section 2.2 of the trawl-gear
/// paper).
TEST(Panel, CountsTwineCoordinatesInBars) {
  const Geometry g = panel();
  const auto &u = g.data.at("u"), &v = g.data.at("v");
  ASSERT_EQ(u.size(), g.elements.size());
  for (std::size_t i = 0; i < g.elements.size(); ++i) {
    const auto [U, V] = g.names.panel[g.elements[i]];
    EXPECT_EQ(u[i], U + V);
    EXPECT_EQ(v[i], V - U);
  }
  EXPECT_EQ(u[1], 2);  // node 1: U = 2, V = 0
  EXPECT_EQ(v[1], -2);
  EXPECT_EQ(g.data.at("bar_length"), std::vector<double>(8, 0.1));
}

std::string netting(const std::string& word) {
  return "panel = { across = 4, along = 3, bar = 0.1, netting = \"" + word +
         "\" }\ncells = [2, 2]\nsketch = [[0, 0, 0], [2, 0, 0], [2, 0, -4], [0, 0, -4]]\n";
}

/// The number of knots of a panel, which is also the number of bars of each direction: half of |d| over all
/// triangles, with d twice the area in twine coordinates.
double knots(const Geometry& g) {
  const auto &u = g.data.at("u"), &v = g.data.at("v");
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); i += 3)
    sum += 0.5 * std::abs((u[i + 1] - u[i]) * (v[i + 2] - v[i]) - (u[i + 2] - u[i]) * (v[i + 1] - v[i]));
  return sum;
}

TEST(CrossedPanel, HasAsManyKnots) { EXPECT_NEAR(knots(panel(crossed())), 2 * 4 * 3, 1e-12); }

TEST(Panel, TurnsMeshesByARightAngleForT90) {
  const Geometry diamond = panel(netting("diamond")), t90 = panel(netting("t90"));
  EXPECT_EQ(diamond.data, panel().data);
  for (std::size_t i = 0; i < t90.elements.size(); ++i) {
    const auto [U, V] = t90.names.panel[t90.elements[i]];
    EXPECT_EQ(t90.data.at("u")[i], V + U);
    EXPECT_EQ(t90.data.at("v")[i], U - V);
  }
  EXPECT_NEAR(knots(diamond), 2 * 4 * 3, 1e-12);
  EXPECT_NEAR(knots(t90), 2 * 4 * 3, 1e-12);
}

TEST(Panel, HasOneKnotPerMeshOfSquareNetting) {
  const Geometry g = panel(netting("square"));
  for (std::size_t i = 0; i < g.elements.size(); ++i) {
    const auto [U, V] = g.names.panel[g.elements[i]];
    EXPECT_EQ(g.data.at("u")[i], U);
    EXPECT_EQ(g.data.at("v")[i], V);
  }
  EXPECT_NEAR(knots(g), 4 * 3, 1e-12);
}

TEST(Panel, KnowsNoOtherNetting) {
  Input in(netting("hexagonal"));
  read_panel(in.reader);
  EXPECT_NE(in.diagnostics.render(false).find("hexagonal"), std::string::npos);
}

TEST(Panel, KeepsItsAreaInMeshesWhateverTheCells) {
  for (const char* cells : {"[1, 1]", "[2, 2]", "[3, 5]", "[7, 4]"}) {
    const Geometry g = panel("panel = { across = 4, along = 3, bar = 0.1 }\ncells = " + std::string(cells) +
                             "\nsketch = [[0, 0, 0], [2, 0, 0], [2, 0, -4], [0, 0, -4]]\n");
    double area = 0;
    for (std::size_t t = 0; 3 * t < g.elements.size(); ++t) {
      const auto n = triangle(g, t);
      const auto &a = g.names.panel[n[0]], &b = g.names.panel[n[1]], &c = g.names.panel[n[2]];
      area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    }
    EXPECT_NEAR(area, 12, 1e-12) << cells;
  }
}

TEST(Panel, StartsOnTheSurfaceThroughItsCorners) {
  const Geometry g = panel(
      "panel = { across = 4, along = 3, bar = 0.1 }\ncells = [2, 2]\n"
      "sketch = [[0, 0, 0], [4, 0, 0], [4, 0, 4], [0, 8, 0]]\n");
  EXPECT_EQ(at(g, 4), (std::array<double, 3>{2, 2, 1}));  // mean of the corners
}

TEST(Panel, RefusesMoreTrianglesThanMemoryHolds) {
  Input in(
      "panel = { across = 4, along = 3, bar = 0.1 }\ncells = [100000, 100000]\n"
      "sketch = [[0, 0, 0], [2, 0, 0], [2, 0, -4], [0, 0, -4]]\n");
  read_panel(in.reader);
  EXPECT_EQ(in.error(), "2:9: cells: makes 20000000000 triangles; at most 20000000 are taken in one part");
}

Geometry tube(const std::string& where, const std::string& cells = "[8, 2]") {
  return panel("panel = { across = 8, along = 6, bar = 0.1 }\ncells = " + cells + "\ntube = " + where + "\n");
}

TEST(Tube, BeginsOnTopAndTurnsClockwiseForOneWhoLooksAft) {
  const Geometry g = tube("{ from = [1, 2, 3], to = [5, 2, 3], radius = 0.5, radius_aft = 1.5 }");
  const auto near = [&](std::uint32_t node, double x, double y, double z) {
    const auto p = at(g, node);
    EXPECT_NEAR(std::hypot(p[0] - x, p[1] - y, p[2] - z), 0, 1e-14) << node;
  };
  near(0, 1, 2, 3.5);  // top of the fore ring
  near(2, 1, 1.5, 3);  // looking along x, y is to the left: a quarter turn clockwise leads to -y
  near(4, 1, 2, 2.5);
  near(8, 1, 2, 3.5);  // the right edge coincides with the left one
  near(9, 3, 2, 4);    // half way aft the radius is 1
  near(18, 5, 2, 4.5);
}

TEST(Tube, ShowsItsTrianglesCounterClockwiseToTheOutside) {
  for (const char* axis : {"to = [5, 2, 3]", "to = [1, 2, -9]", "to = [1, 8, 9]"}) {
    const Geometry g = tube(std::string("{ from = [1, 2, 3], ") + axis + ", radius = 0.5 }");
    for (std::size_t t = 0; 3 * t < g.elements.size(); ++t) {
      const auto n = triangle(g, t);
      std::array<std::array<double, 3>, 3> x{at(g, n[0]), at(g, n[1]), at(g, n[2])};
      const auto first = at(g, 0), opposite = at(g, 4);
      // The product of the normal and the vector from the axis at the fore edge; the component of this vector
      // along the axis adds nothing.
      double outwards = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        const double normal =
            (x[1][b] - x[0][b]) * (x[2][c] - x[0][c]) - (x[1][c] - x[0][c]) * (x[2][b] - x[0][b]);
        outwards += normal * ((x[0][a] + x[1][a] + x[2][a]) / 3 - (first[a] + opposite[a]) / 2);
      }
      EXPECT_GT(outwards, 0) << axis << ' ' << t;
    }
  }
}

TEST(Tube, MustHaveALengthAndNoSketchBesideIt) {
  Input none(
      "panel = { across = 4, along = 3, bar = 0.1 }\ncells = [4, 4]\n"
      "tube = { from = [1, 0, 0], to = [1, 0, 0], radius = 1 }\n");
  read_panel(none.reader);
  EXPECT_NE(none.error().find("is where the tube begins"), std::string::npos) << none.error();
  Input both(
      "panel = { across = 4, along = 3, bar = 0.1 }\ncells = [4, 4]\n"
      "sketch = [[0, 0, 0], [2, 0, 0], [2, 0, -4], [0, 0, -4]]\n"
      "tube = { from = [1, 0, 0], to = [2, 0, 0], radius = 1 }\n");
  read_panel(both.reader);
  EXPECT_NE(both.error().find("is given beside sketch"), std::string::npos) << both.error();
}

TEST(Panel, CountsMeshesToItsAftEdge) {
  const Geometry g = panel();  // 4 x 3 meshes
  for (std::size_t i = 0; i < g.elements.size(); ++i)
    EXPECT_EQ(g.data.at("to_aft")[i], 3 - g.names.panel[g.elements[i]][1]);
}

/// The keys of a panel of 4 x 6 meshes in 2 x 3 cells, each of 2 x 2 meshes.
constexpr const char* kSquarePanel =
    "panel = { across = 4, along = 6, bar = 0.1 }\ncells = [2, 3]\n"
    "sketch = [[0, 0, 0], [2, 0, 0], [2, 0, -6], [0, 0, -6]]\n";

Geometry panel_in_bars(const std::string& text = kSquarePanel) {
  Input in(text);
  Geometry g = read_panel_in_bars(in.reader);
  EXPECT_EQ(in.diagnostics.render(false), "");
  return g;
}

TEST(PanelInBars, NumbersCornersAsTrianglesDoAndCentresBehindThem) {
  const Geometry bars = panel_in_bars(), triangles = panel(kSquarePanel);
  ASSERT_EQ(bars.node_count(), 12u + 6u);
  for (std::size_t n = 0; n < 12; ++n) EXPECT_EQ(at(bars, n), at(triangles, n));
  EXPECT_EQ(at(bars, 12), (std::array<double, 3>{0.5, 0, -1}));
  EXPECT_EQ(at(bars, 13), (std::array<double, 3>{1.5, 0, -1}));
  EXPECT_EQ(at(bars, 14), (std::array<double, 3>{0.5, 0, -3}));
  EXPECT_EQ(bars.names.sets, triangles.names.sets);
  EXPECT_EQ(bars.names.panel[14], (std::array<double, 2>{1, 3}));
}

TEST(PanelInBars, HasABarFromEveryCentreToItsFourCorners) {
  const Geometry g = panel_in_bars();
  ASSERT_EQ(g.elements.size(), 2u * 4u * 6u);
  const Nodes first(g.elements.begin(), g.elements.begin() + 8), last(g.elements.end() - 8, g.elements.end());
  EXPECT_EQ(first, (Nodes{12, 0, 12, 1, 12, 4, 12, 3}));
  EXPECT_EQ(last, (Nodes{17, 7, 17, 8, 17, 11, 17, 10}));
}

TEST(PanelInBars, SpansTrianglesBetweenItsBarsThatFaceAsThoseOfAPanelDo) {
  const Geometry g = panel_in_bars();
  ASSERT_EQ(g.faces.nodes.size(), 3u * 4u * 6u);
  const Nodes first(g.faces.nodes.begin(), g.faces.nodes.begin() + 12);
  EXPECT_EQ(first, (Nodes{0, 1, 12, 1, 4, 12, 4, 3, 12, 3, 0, 12}));
  const auto& to_aft = g.faces.data.at("to_aft");
  ASSERT_EQ(to_aft.size(), g.faces.nodes.size());
  for (std::size_t i = 0; i < to_aft.size(); ++i)
    EXPECT_DOUBLE_EQ(to_aft[i], 6 - g.names.panel[g.faces.nodes[i]][1]);
}

/// The total length of twine of a panel in bars [m].
double twine_in_bars(const Geometry& g) {
  double sum = 0;
  for (std::size_t e = 0; e < g.elements.size() / 2; ++e)
    sum += g.data.at("rest_length")[e] * g.data.at("parallel")[e];
  return sum;
}
double twine_in_triangles(const Geometry& g) {
  double sum = 0;
  const auto &u = g.data.at("u"), &v = g.data.at("v");
  for (std::size_t e = 0; e < g.elements.size() / 3; ++e) {
    const std::size_t a = 3 * e, b = a + 1, c = a + 2;
    sum +=
        std::abs((u[b] - u[a]) * (v[c] - v[a]) - (u[c] - u[a]) * (v[b] - v[a])) * g.data.at("bar_length")[e];
  }
  return sum;
}

TEST(PanelInBars, HasTheTwineOfTheTrianglesAtAnyCells) {
  const std::string text = kSquarePanel;
  for (const char* cells : {"[2, 3]", "[4, 6]", "[8, 12]", "[10, 15]"}) {
    std::string scene = text;
    scene.replace(scene.find("[2, 3]"), 6, cells);
    EXPECT_NEAR(twine_in_bars(panel_in_bars(scene)), 4 * 24 * 0.1, 1e-12) << cells;  // four bars per mesh
    EXPECT_NEAR(twine_in_triangles(panel(scene)), 4 * 24 * 0.1, 1e-12) << cells;
  }
}

TEST(PanelInBars, GroupsAsManyTwinesAsACellHasMeshes) {
  const Geometry g = panel_in_bars();
  EXPECT_EQ(g.data.at("rest_length"), std::vector<double>(24, 0.2));
  EXPECT_EQ(g.data.at("parallel"), std::vector<double>(24, 2.0));
}

TEST(PanelInBars, IsTheNetKnotByKnotWithOneMeshACell) {
  const Geometry g = panel_in_bars(
      "panel = { across = 40, along = 40, bar = 0.6 }\ncells = [40, 40]\n"
      "sketch = [[-16, 0, 0], [16, 0, 0], [16, 0, -34], [-16, 0, -34]]\n");
  EXPECT_EQ(g.node_count(), 41u * 41u + 40u * 40u);
  EXPECT_EQ(g.data.at("rest_length"), std::vector<double>(6400, 0.6));
  EXPECT_EQ(g.data.at("parallel"), std::vector<double>(6400, 1.0));
}

std::string complaint_about(const std::string& meshes, const std::string& cells) {
  Input in("panel = { " + meshes + ", bar = 0.1 }\ncells = " + cells +
           "\nsketch = [[0, 0, 0], [2, 0, 0], [2, 0, -6], [0, 0, -6]]\n");
  EXPECT_TRUE(read_panel_in_bars(in.reader).elements.empty());
  return in.diagnostics.render(false);
}

TEST(PanelInBars, RefusesCellsWhoseBarsWouldCrossTwinesAndNamesTheNearestThatFit) {
  const std::string oblong = complaint_about("across = 100, along = 150", "[24, 48]");
  EXPECT_NE(oblong.find(":2:9: "), std::string::npos) << oblong;
  EXPECT_NE(oblong.find("makes cells of 4.16667 x 3.125 meshes"), std::string::npos) << oblong;
  EXPECT_NE(oblong.find("cells = [30, 45]"), std::string::npos) << oblong;  // 6.7 away; [32, 48] is 8 away
  const std::string hopeless = complaint_about("across = 1, along = 0.123456789", "[2, 2]");
  EXPECT_NE(hopeless.find("no cells fit this panel"), std::string::npos) << hopeless;
}

TEST(PanelInBars, LiesRoundATubeWithItsCentres) {
  const Geometry g = panel_in_bars(
      "panel = { across = 8, along = 4, bar = 0.1 }\ncells = [8, 4]\n"
      "tube = { from = [0, 0, 0], to = [3, 0, 0], radius = 2 }\n");
  for (std::size_t n = 0; n < g.node_count(); ++n)
    EXPECT_NEAR(std::hypot(at(g, n)[1], at(g, n)[2]), 2, 1e-14) << n;
}

TEST(Layout, IsToldByWhatAnElementDeclares) {
  const auto layout = [](std::uint32_t stencil, std::vector<netloft_datum> data) {
    ElementType type;
    type.element.stencil = stencil, type.data = std::move(data);
    return layout_of(type);
  };
  const netloft_datum length{sizeof(netloft_datum), 1, "rest_length", "m", ""},
      parallel{sizeof(netloft_datum), 1, "parallel", "1", ""};
  EXPECT_EQ(layout(NETLOFT_NODE, {}), Layout::point);
  EXPECT_EQ(layout(NETLOFT_BAR, {length}), Layout::line);
  EXPECT_EQ(layout(NETLOFT_BAR, {length, parallel}), Layout::panel_in_bars);
  EXPECT_EQ(layout(NETLOFT_TRIANGLE, {}), Layout::panel_in_triangles);
}

TEST(Rope, SpreadsNodesEvenlyAlongItsSketch) {
  const Geometry g = rope("length = 10\ncells = 4\nsketch = [[0, 0, 0], [3, 0, 0], [3, 0, -1]]\n");
  ASSERT_EQ(g.node_count(), 5u);
  EXPECT_EQ(at(g, 1), (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(at(g, 3), (std::array<double, 3>{3, 0, 0}));
  EXPECT_EQ(at(g, 4), (std::array<double, 3>{3, 0, -1}));
}

TEST(Rope, HasBarsOfOneLengthThatAddUp) {
  const Geometry g = rope("length = 10\ncells = 4\nsketch = [[0, 0, 0], [3, 0, 0]]\n");
  EXPECT_EQ(g.elements, (Nodes{0, 1, 1, 2, 2, 3, 3, 4}));
  EXPECT_EQ(g.data.at("rest_length"), std::vector<double>(4, 2.5));
}

TEST(Rope, HasAMiddleIfTheNumberOfItsBarsIsEven) {
  const auto even = rope("length = 1\ncells = 4\nsketch = [[0, 0, 0], [3, 0, 0]]\n").names.sets;
  EXPECT_EQ(even.at("start"), Nodes{0});
  EXPECT_EQ(even.at("middle"), Nodes{2});
  EXPECT_EQ(even.at("end"), Nodes{4});
  EXPECT_FALSE(
      rope("length = 1\ncells = 3\nsketch = [[0, 0, 0], [3, 0, 0]]\n").names.sets.contains("middle"));
}

TEST(Rope, StartsInAPointIfItsSketchIsOne) {
  const Geometry g = rope("length = 1\ncells = 2\nsketch = [[1, 2, 3], [1, 2, 3]]\n");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(at(g, i), (std::array<double, 3>{1, 2, 3}));
}

TEST(PointPart, IsOneNode) {
  Input in("at = [1, \"2 m\", \"300 cm\"]");
  const Geometry g = read_point(in.reader);
  EXPECT_EQ(g.positions, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(g.names.sets.at("point"), Nodes{0});
  EXPECT_EQ(g.data.at("pieces"), std::vector<double>{1});
}

TEST(AlongLine, WalksByLengthAndStaysOnTheLine) {
  const std::vector<std::array<double, 3>> line = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 3, 0}};
  EXPECT_EQ(along_line(line, 0), line.front());
  EXPECT_EQ(along_line(line, 0.5), (std::array<double, 3>{1, 1, 0}));
  EXPECT_EQ(along_line(line, 1), line.back());
  EXPECT_EQ(along_line({{5, 6, 7}}, 0.3), (std::array<double, 3>{5, 6, 7}));
}

}  // namespace
}  // namespace netloft::scenes
