// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/division.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/unit/io/gears/plan/plans.hpp"

namespace netloft::gears {
namespace {

void expect_same(const GearMesh& a, const GearMesh& b) {
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.middle, b.middle);
  ASSERT_EQ(a.panels.size(), b.panels.size());
  for (std::size_t p = 0; p < a.panels.size(); ++p) {
    EXPECT_EQ(a.panels[p].nodes, b.panels[p].nodes);
    EXPECT_EQ(a.panels[p].meshes, b.panels[p].meshes);
    EXPECT_EQ(a.panels[p].triangles, b.panels[p].triangles);
    EXPECT_EQ(a.panels[p].sets, b.panels[p].sets);
  }
  ASSERT_EQ(a.ropes.size(), b.ropes.size());
  for (std::size_t r = 0; r < a.ropes.size(); ++r) {
    EXPECT_EQ(a.ropes[r].nodes, b.ropes[r].nodes);
    EXPECT_EQ(a.ropes[r].rest_lengths, b.ropes[r].rest_lengths);
    EXPECT_EQ(a.ropes[r].sets, b.ropes[r].sets);
  }
}

TEST(Division, OfAPlanDependsOnItsGeometryAlone) {
  for (const char* file : {"83-112-eastern.toml", "four-panel.toml", "two-panel.toml"})
    for (const Extent extent : {Extent::half, Extent::whole}) {
      const auto checked = check_text(library_text(file));
      const NetPlan geometry = geometry_of(checked.plan);
      const Fineness fineness{.nodes = 300, .size = 0, .finer = {}};
      const Gear gear = make_gear(checked.plan, extent), bare = make_gear(geometry, extent);
      const GearMesh mesh = divide(gear, fineness), of_bare = divide(bare, fineness);
      expect_same(mesh, of_bare);
      EXPECT_EQ(StartShapes(gear, mesh).with(gear), StartShapes(bare, of_bare).with(gear)) << file;
    }
}

TEST(Divisions, AreMadeAgainForAnotherGeometryAndKeptForAnotherMaterial) {
  auto checked = check_text(library_text("four-panel.toml"));
  const Fineness fineness{.nodes = 300, .size = 0, .finer = {}};
  Divisions divisions;
  const auto first = divisions.of(checked.plan, Extent::half, fineness);
  checked.plan.panels[0].twine_diameter *= 2;
  EXPECT_EQ(divisions.of(checked.plan, Extent::half, fineness), first);
  checked.plan.panels[0].mesh *= 1.01;
  EXPECT_NE(divisions.of(checked.plan, Extent::half, fineness), first);
  checked.plan.panels[0].mesh /= 1.01;
  EXPECT_NE(divisions.of(checked.plan, Extent::whole, fineness), first);
}

TEST(DivideAlike, GivesTheSameMeshOfTheSameGear) {
  for (const char* file : {"83-112-eastern.toml", "four-panel.toml", "two-panel.toml"})
    for (const Extent extent : {Extent::half, Extent::whole}) {
      const auto checked = check_text(library_text(file));
      const Fineness fineness{.nodes = 300, .size = 0, .finer = {}};
      const Gear gear = make_gear(checked.plan, extent);
      const GearMesh mesh = divide(gear, fineness);
      expect_same(mesh, divide_alike(gear, fineness, *mesh.topology));
    }
}

// One panel gets more meshes, but the gear keeps its triangles.
TEST(DivideAlike, KeepsTheTopologyOfAnotherGear) {
  std::string text = library_text("83-112-eastern.toml");
  const Fineness fineness{.nodes = 300, .size = 0, .finer = {}};
  const auto plan = check_text(text);
  const GearMesh before = divide(make_gear(plan.plan, Extent::half), fineness);
  const std::string depth = "depth = 191";  // of the panel top-body, the second one
  ASSERT_NE(text.find(depth), std::string::npos);
  const auto deeper = check_text(text.replace(text.find(depth), depth.size(), "depth = 192"));
  const GearMesh after = divide_alike(make_gear(deeper.plan, Extent::half), fineness, *before.topology);
  ASSERT_EQ(after.nodes, before.nodes);
  for (std::size_t p = 0; p < before.panels.size(); ++p) {
    EXPECT_EQ(after.panels[p].triangles, before.panels[p].triangles);
    EXPECT_EQ(after.panels[p].nodes, before.panels[p].nodes);
    EXPECT_EQ(after.panels[p].sets, before.panels[p].sets);
  }
  EXPECT_NE(after.panels[1].meshes, before.panels[1].meshes);
  // the panel of the cod-end, which is far from the changed panel
  EXPECT_EQ(after.panels.back().meshes, before.panels.back().meshes);
  double deepest = 0;
  for (const auto& [U, V] : after.panels[1].meshes) deepest = std::max(deepest, V);
  EXPECT_NEAR(deepest, 192, 1e-9);
  for (std::size_t r = 0; r < before.ropes.size(); ++r)
    EXPECT_EQ(after.ropes[r].nodes, before.ropes[r].nodes);
}

TEST(DivideAlike, RefusesAGearWithOtherLines) {
  const Fineness fineness{.nodes = 300, .size = 0, .finer = {}};
  const auto four = check_text(library_text("four-panel.toml")),
             two = check_text(library_text("two-panel.toml"));
  const GearMesh mesh = divide(make_gear(four.plan, Extent::half), fineness);
  EXPECT_THROW(divide_alike(make_gear(two.plan, Extent::half), fineness, *mesh.topology),
               std::invalid_argument);
}

/// The border of a polygon, with points at its corners and in its sides.
std::vector<PlanePoint> border_of(const std::vector<PlanePoint>& corners) {
  constexpr std::size_t kParts = 8;
  std::vector<PlanePoint> border;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t k = 0; k < kParts; ++k) {
      const PlanePoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
      const double t = static_cast<double>(k) / kParts;
      border.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    }
  return border;
}

TEST(MovedWithBorder, MovesInnerPointsAffinelyWithAnAffineBorder) {
  // An L, whose border is not convex.
  const auto border = border_of({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const PlaneMesh mesh = triangulate(border, 0.3);
  ASSERT_GT(mesh.points.size(), border.size());
  const auto affine = [](const PlanePoint& p) {
    return PlanePoint{1.2 * p[0] + 0.3 * p[1] - 1, 0.9 * p[1] - 0.1 * p[0] + 2};
  };
  std::vector<PlanePoint> there;
  for (const PlanePoint& p : border) there.push_back(affine(p));
  const PlaneMesh moved = moved_with_border(mesh, there);
  EXPECT_EQ(moved.triangles, mesh.triangles);
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    for (std::size_t axis = 0; axis < 2; ++axis)
      EXPECT_NEAR(moved.points[k][axis], affine(mesh.points[k])[axis], 1e-12);
  EXPECT_EQ(moved_with_border(mesh, border).points, mesh.points);
}

TEST(MovedWithBorder, RefusesToTurnATriangleOver) {
  const auto border = border_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
             mirrored = border_of({{0, 0}, {-1, 0}, {-1, 1}, {0, 1}});
  EXPECT_THROW(moved_with_border(triangulate(border, 0.3), mirrored), std::invalid_argument);
}

}  // namespace
}  // namespace netloft::gears
