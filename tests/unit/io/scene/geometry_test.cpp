// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/geometry.hpp"

#include <cmath>

#include "tests/unit/io/toml/scratch.hpp"

namespace netloft::io {
namespace {

using testing::Input;
using Nodes = std::vector<std::uint32_t>;

/// 4 x 3 meshes in 2 x 2 cells, a unit square seen from above.
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

/// The paper's section 2.2: a mesh across is one bar along u and one back along v; u = U + V, v = V - U.
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
  EXPECT_EQ(in.error(), "2:9: cells: makes 20000000000 triangles; at most 4000000 are taken in one part");
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
  near(8, 1, 2, 3.5);  // the right edge lies where the left one does
  near(9, 3, 2, 4);    // half way: radius 1
  near(18, 5, 2, 4.5);
}

TEST(Tube, ShowsItsTrianglesCounterClockwiseToTheOutside) {
  for (const char* axis : {"to = [5, 2, 3]", "to = [1, 2, -9]", "to = [1, 8, 9]"}) {
    const Geometry g = tube(std::string("{ from = [1, 2, 3], ") + axis + ", radius = 0.5 }");
    for (std::size_t t = 0; 3 * t < g.elements.size(); ++t) {
      const auto n = triangle(g, t);
      std::array<std::array<double, 3>, 3> x{at(g, n[0]), at(g, n[1]), at(g, n[2])};
      const auto first = at(g, 0), opposite = at(g, 4);
      double outwards =
          0;  // normal . way from the axis at the fore edge; what is along the axis adds nothing
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
  EXPECT_NE(both.error().find("stands beside a sketch"), std::string::npos) << both.error();
}

TEST(Panel, CountsMeshesToItsAftEdge) {
  const Geometry g = panel();  // 4 x 3 meshes
  for (std::size_t i = 0; i < g.elements.size(); ++i)
    EXPECT_EQ(g.data.at("to_aft")[i], 3 - g.names.panel[g.elements[i]][1]);
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
  EXPECT_EQ(g.data.at("share"), std::vector<double>{1});
}

TEST(AlongLine, WalksByLengthAndStaysOnTheLine) {
  const std::vector<std::array<double, 3>> line = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 3, 0}};
  EXPECT_EQ(along_line(line, 0), line.front());
  EXPECT_EQ(along_line(line, 0.5), (std::array<double, 3>{1, 1, 0}));
  EXPECT_EQ(along_line(line, 1), line.back());
  EXPECT_EQ(along_line({{5, 6, 7}}, 0.3), (std::array<double, 3>{5, 6, 7}));
}

}  // namespace
}  // namespace netloft::io
