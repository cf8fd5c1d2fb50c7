// SPDX-License-Identifier: BSD-3-Clause
//
// Divides gears without a mesh: parts that are sewn together share nodes, and no netting is lost.
#include "io/scenes/import/import.hpp"
#include "tests/unit/io/scenes/import/samples.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <set>

namespace netloft::scenes::femnet {
namespace {

const std::string kPolygon = sample("10_polygon_panel.don");

struct Divided {
  explicit Divided(const std::string& text) : read(text) {
    if (read.diagnostics.errors() == 0) mesh = divide_gear(read.gear, read.diagnostics);
  }
  explicit Divided(GearFile gear) : read(kPolygon) {
    read.gear = std::move(gear);
    mesh = divide_gear(read.gear, read.diagnostics);
  }
  bool says(const std::string& words) const { return read.says(words); }
  ReadGear read;
  MeshFile mesh;
};

double twine_sides(const MeshFile& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::size_t i) { return t.UV[i]; };
    // By u = U + V and v = V − U, twice the area in mesh sides is four times the area in meshes.
    sum += 2 * ((at(2) - at(0)) * (at(5) - at(1)) - (at(4) - at(0)) * (at(3) - at(1)));
  }
  return sum;
}

/// A panel with these corners (U, V), drawn at the same numbers in metres.
Panel panel_of(const std::vector<std::array<double, 2>>& corners, double step) {
  Panel p;
  p.side = 0.5, p.step = step, p.inner_type = 1;
  for (const auto& [U, V] : corners) p.corners.push_back({{U, V, 0}, U, V, 1, 1});
  return p;
}
GearFile gear_of(std::vector<Panel> panels) {
  GearFile gear;
  gear.panels = std::move(panels);
  gear.types.resize(1);
  return gear;
}

/// FEMNET's meshes of the gear have the same numbers of nodes, triangles and sides of twine
/// (10_polygon_panel.expected.json).
TEST(DividedGear, HasTheMeshThatFemnetMakes) {
  const struct {
    const char* step;
    std::size_t nodes, triangles;
  } known[] = {{"1", 21, 28}, {"0.5", 65, 104}, {"0.25", 225, 400}};
  for (const auto& k : known) {
    const Divided gear(changed(kPolygon, "Meshing step (m): 1", std::string("Meshing step (m): ") + k.step));
    ASSERT_EQ(gear.read.diagnostics.errors(), 0) << gear.read.diagnostics.render(false);
    EXPECT_EQ(gear.mesh.nodes.size(), k.nodes);
    EXPECT_EQ(gear.mesh.triangles.size(), k.triangles);
    EXPECT_NEAR(twine_sides(gear.mesh), 600, 1e-9);
  }
}

TEST(DividedGear, GivesNodesTheTypesOfCornersSidesAndPanels) {
  const Divided gear(kPolygon);
  std::vector<int> count(4);
  for (const auto& n : gear.mesh.nodes) ++count[static_cast<std::size_t>(n.type)];
  EXPECT_EQ(count, (std::vector<int>{2, 14, 3, 2}));
}

TEST(DividedGear, PutsTheBarsOfACableOnTheSideThatItIsSewnTo) {
  const Divided gear(kPolygon);
  ASSERT_EQ(gear.mesh.bars.size(), 4u);
  EXPECT_EQ(gear.mesh.bars[1].shares, (std::array<double, 2>{0.25, 0.5}));
  for (const auto& b : gear.mesh.bars) EXPECT_EQ(gear.mesh.nodes[b.nodes[0]].at[1], 0);
}

TEST(DividedGear, DividesASideAsTheCableThatComesFirst) {
  const Divided gear(changed(changed(kPolygon, "pa: 1 el: 1\n\nNumber", "el: 1 pa: 1\n\nNumber"),
                             "Bars number: 1", "Bars number: 7"));
  ASSERT_EQ(gear.mesh.bars.size(), 7u);
  EXPECT_NEAR(twine_sides(gear.mesh), 600, 1e-9);
  std::set<std::uint32_t> of_netting;
  for (const auto& t : gear.mesh.triangles) of_netting.insert(t.nodes.begin(), t.nodes.end());
  for (const auto& b : gear.mesh.bars)
    EXPECT_TRUE(of_netting.count(b.nodes[0]) && of_netting.count(b.nodes[1]));
}

/// Areas by hand [meshes²]: a triangle, a pentagon, an L, and a star with eleven corners.
TEST(DividedGear, FillsPolygonsOfAnyNumberOfCorners) {
  std::vector<std::array<double, 2>> star;
  for (int k = 0; k < 22; ++k)
    star.push_back({(k % 2 ? 10 : 25) * std::cos(k * 0.2855993321445266),
                    (k % 2 ? 10 : 25) * std::sin(k * 0.2855993321445266)});
  const struct {
    std::vector<std::array<double, 2>> corners;
    double area;
  } polygons[] = {{{{0, 0}, {12, 0}, {0, 9}}, 54},
                  {{{0, 0}, {8, 0}, {10, 5}, {4, 9}, {-2, 5}}, 74},
                  {{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}, 64},
                  {star, 11 * 10 * 25 * std::sin(0.2855993321445266)}};
  for (auto polygon : polygons)
    for (const double step : {0.4, 1.0, 3.0, 50.0})
      for (const bool turns : {false, true}) {
        if (turns) std::reverse(polygon.corners.begin(), polygon.corners.end());
        const Divided gear(gear_of({panel_of(polygon.corners, step)}));
        ASSERT_EQ(gear.read.diagnostics.errors(), 0) << gear.read.diagnostics.render(false);
        EXPECT_NEAR(twine_sides(gear.mesh), 4 * polygon.area, 1e-9 * polygon.area);
        for (const auto& t : gear.mesh.triangles)
          for (std::size_t k = 0; k < 3; ++k) {  // positions equal (U, V), as in the drawing
            EXPECT_NEAR(gear.mesh.nodes[t.nodes[k]].at[0], t.UV[2 * k], 1e-9);
            EXPECT_NEAR(gear.mesh.nodes[t.nodes[k]].at[1], t.UV[2 * k + 1], 1e-9);
          }
      }
}

TEST(DividedGear, HasNoFlatTriangles) {
  const Divided gear(gear_of({panel_of({{0, 0}, {30, 0}, {37, 22}, {5, 31}, {-4, 9}}, 1)}));
  for (const auto& t : gear.mesh.triangles) {
    std::array<double, 2> p[3];
    for (std::size_t k = 0; k < 3; ++k) p[k] = {t.UV[2 * k], std::sqrt(3.0) * t.UV[2 * k + 1]};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3];
      const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      const double longest =
          std::max({std::hypot(b[0] - a[0], b[1] - a[1]), std::hypot(c[0] - a[0], c[1] - a[1])});
      EXPECT_GT(area / longest, 0.1);
    }
  }
}

TEST(DividedGear, SewsPanelsWhereCornersLieNearOneAnother) {
  GearFile gear = gear_of({panel_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 1),
                           panel_of({{0, 10}, {10, 10}, {10, 20}, {0, 20}}, 3)});
  gear.panels[1].corners[0].at[0] += 0.01;
  const std::size_t apart = Divided(gear).mesh.nodes.size();
  gear.link_distance = 0.02;
  const Divided sewn(gear);
  EXPECT_NEAR(twine_sides(sewn.mesh), 4 * 200, 1e-9);
  std::set<std::uint32_t> nodes[2], common;
  for (const auto& t : sewn.mesh.triangles)
    nodes[static_cast<std::size_t>(t.panel)].insert(t.nodes.begin(), t.nodes.end());
  std::set_intersection(nodes[0].begin(), nodes[0].end(), nodes[1].begin(), nodes[1].end(),
                        std::inserter(common, common.begin()));
  EXPECT_EQ(common.size(), 6u);  // 10 mesh sides of 0.5 m in steps of 1 m: five parts
  EXPECT_EQ(sewn.mesh.nodes.size() + 3, apart);
}

/// The links connect the corners of two sides of one panel, which thereby becomes a tube.
TEST(DividedGear, SewsAPanelToItself) {
  GearFile gear = gear_of({panel_of({{0, 0}, {20, 0}, {20, 10}, {0, 10}}, 1)});
  gear.links = {{{true, 0, 0}, {true, 0, 1}}, {{true, 0, 3}, {true, 0, 2}}};
  const Divided tube(gear);
  EXPECT_NEAR(twine_sides(tube.mesh), 4 * 200, 1e-9);
  const std::size_t flat = Divided(gear_of(gear.panels)).mesh.nodes.size();
  EXPECT_EQ(tube.mesh.nodes.size(), flat - 6);
}

TEST(DividedGear, TellsOfNettingThatATipLoses) {
  GearFile gear = gear_of({panel_of({{0, 0}, {10, 30}, {-10, 30}}, 2)});
  gear.links = {{{true, 0, 1}, {true, 0, 2}}};
  const Divided cone(gear);
  EXPECT_EQ(cone.read.diagnostics.errors(), 0);
  const double lost = 4 * 300 - twine_sides(cone.mesh);
  EXPECT_EQ(cone.says("between sides that are sewn to one another"), lost > 1e-6);
  for (const auto& t : cone.mesh.triangles) EXPECT_EQ(std::set(t.nodes.begin(), t.nodes.end()).size(), 3u);
}

TEST(DividedGear, TellsWhereLinkedCornersHaveDifferentTypes) {
  const Divided gear(changed(kPolygon, "2 4 0 0 1\nTraction", "2 4 0 0 3\nTraction"));
  EXPECT_EQ(gear.read.diagnostics.errors(), 0);
  EXPECT_TRUE(
      gear.says("corner 2 is of type 3, but linked to a corner of type 1, and the node gets that type"));
}

TEST(DividedGear, GivesNodesInABoxAnotherType) {
  const Divided gear(kPolygon + "\ninput type_noeud_XYZ_SUPINF 13 0.9 3.1 -2.1 -1.9 -1 1 1\n");
  ASSERT_EQ(gear.read.diagnostics.errors(), 0) << gear.read.diagnostics.render(false);
  EXPECT_EQ(
      std::count_if(gear.mesh.nodes.begin(), gear.mesh.nodes.end(), [](auto& n) { return n.type == 0; }), 5);
}

TEST(DividedGear, AnswersWhatCannotBeDividedWithItsPlace) {
  const struct {
    const char *old, *fresh, *says;
  } wrong[] = {
      {"pa: 1 nd: 2", "pa: 1 nd: 9", "the link names corner 9 of panel 1, which has 4"},
      {"pa: 1 nd: 2", "pa: 3 nd: 2", "the link names panel 3, which does not exist"},
      {"el: 1 nd: 2", "el: 0 nd: 2", "the link names cable 0, which does not exist"},
      {"Meshing step (m): 1", "Meshing step (m): 0", "the meshing step of the panel is 0 m"},
      {"Meshing step (m): 1", "Meshing step (m): -1", "the meshing step of the panel is -1 m"},
      {"Meshing step (m): 1", "Meshing step (m): 1e-6", "more than 1e+06 nodes"},
      {"Unstretched length (m): 0.2", "Unstretched length (m): 0", "the mesh side of the panel is 0 m"},
      {"3 3 -2 0 15 -10 4 2", "3 3 -2 0 15 1e300 4 2", "beyond a million meshes"},
      {"3 3 -2 0 15 -10 4 2", "3 3e9 -2 0 15 -10 4 2", "beyond a million metres"},
      {"3 3 -2 0 15 -10 4 2", "3 3 -2 0 15 0 4 2\n", "encloses no netting"},
      {"3 3 -2 0 15 -10 4 2", "3 3 -2 0 15 -10 7 2", "nodes of type 7 are needed here"},
      {"Type of internal nodes: 2", "Type of internal nodes: 0", "nodes of type 0 are needed here"},
      {"4 1 -2 0 5 -10 4 2", "4 1 -2 0 15 10 4 2", "encloses no netting"},
  };
  for (const auto& w : wrong) {
    const Divided gear(changed(kPolygon, w.old, w.fresh));
    EXPECT_GE(gear.read.diagnostics.errors(), 1) << w.fresh;
    EXPECT_TRUE(gear.says(w.says)) << w.fresh << "\n" << gear.read.diagnostics.render(false);
    EXPECT_TRUE(gear.says("gear.don:")) << gear.read.diagnostics.render(false);
  }
}

/// Writes files into a separate folder.
class GearInFolder : public testing::Test {
 protected:
  GearInFolder() { std::filesystem::create_directories(folder_); }
  ~GearInFolder() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      ("divided-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
       std::to_string(std::random_device()()));
};

TEST_F(GearInFolder, IsDividedWhereItHasNoMesh) {
  formats::Diagnostics diagnostics;
  const auto gear = import_femnet({write("g.don", kPolygon), {}, "g.mesh"}, diagnostics);
  EXPECT_EQ(diagnostics.errors(), 0) << diagnostics.render(false);
  EXPECT_EQ(gear.nodes, 21u);
  EXPECT_TRUE(gear.left_out.empty());
  EXPECT_NE(gear.scene.find("note, line 0, the mesh: there is none: the gear is divided"), std::string::npos);
}

TEST_F(GearInFolder, IsDividedWhereItsMeshIsOlder) {
  const auto path = write("g.don", sample("01_two_bars.don"));
  write("g.mdg", changed(sample("01_two_bars.mdg"), "0.5000000 1.0000000     1", "35 -25 0"));
  formats::Diagnostics diagnostics;
  const auto gear = import_femnet({path, {}, "g.mesh"}, diagnostics);
  EXPECT_EQ(diagnostics.errors(), 0) << diagnostics.render(false);
  EXPECT_NE(gear.scene.find("older than the gear, g.mdg:16:"), std::string::npos) << gear.scene;
  EXPECT_EQ(gear.nodes, 3u);

  formats::Diagnostics of_named;  // a mesh that the user names is used or an error
  import_femnet({path, folder_ / "g.mdg", "g.mesh"}, of_named);
  EXPECT_EQ(of_named.errors(), 1);
}

TEST_F(GearInFolder, IsRefusedWhereItsMeshIsDamaged) {
  const auto path = write("g.don", sample("01_two_bars.don"));
  write("g.mdg", sample("01_two_bars.mdg").substr(0, 300));
  formats::Diagnostics diagnostics, again;
  import_femnet({path, {}, "g.mesh"}, diagnostics);
  EXPECT_GE(diagnostics.errors(), 1);
  EXPECT_EQ(import_femnet({path, {}, "g.mesh", true}, again).nodes, 3u);  // --divide
  EXPECT_EQ(again.errors(), 0) << again.render(false);
}

TEST_F(GearInFolder, LeavesOutWhatChangesTheDrawingWhereItIsDivided) {
  formats::Diagnostics diagnostics;
  const auto gear =
      import_femnet({write("g.don", kPolygon + "\ninput rot_X 30\n"), {}, "g.mesh"}, diagnostics);
  ASSERT_EQ(gear.left_out.size(), 1u);
  EXPECT_NE(gear.left_out[0].find("rot_X"), std::string::npos);
}

}  // namespace
}  // namespace netloft::scenes::femnet
