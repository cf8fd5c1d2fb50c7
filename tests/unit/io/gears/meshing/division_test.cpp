// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/division.hpp"

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

}  // namespace
}  // namespace netloft::gears
