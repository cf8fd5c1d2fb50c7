// SPDX-License-Identifier: BSD-3-Clause
//
// Broken files: each gives an error with a place, without a crash and without much memory.
#include "tests/unit/io/scenes/import/samples.hpp"

#include <algorithm>
#include <random>

namespace netloft::scenes::femnet {
namespace {

const std::string kHostileGear = sample("03_node_force_symmetry.don"),
                  kHostileMesh = sample("03_node_force_symmetry.mdg");

/// The end of the first part of the file. Behind it are notes, which may be cut off.
std::size_t end_of_values(const std::string& gear) { return gear.find("Speed display: 0"); }

class CutGear : public testing::TestWithParam<int> {};

TEST_P(CutGear, IsSaidToEndTooEarly) {
  const ReadGear read(
      kHostileGear.substr(0, end_of_values(kHostileGear) * static_cast<std::size_t>(GetParam()) / 16));
  ASSERT_EQ(read.diagnostics.errors(), 1) << read.diagnostics.render(false);
  EXPECT_GT(read.diagnostics.sorted().back().place.line, 0);
}

INSTANTIATE_TEST_SUITE_P(Each, CutGear, testing::Range(0, 16));

class CutMesh : public testing::TestWithParam<int> {};

TEST_P(CutMesh, IsSaidToEndTooEarly) {
  const std::size_t end = kHostileMesh.find("Nombre de surfaces hexagonales");
  const ImportedSample read(kHostileGear,
                            kHostileMesh.substr(0, (end - 40) * static_cast<std::size_t>(GetParam()) / 14));
  EXPECT_EQ(read.read.diagnostics.errors(), 1) << read.read.diagnostics.render(false);
  EXPECT_TRUE(read.imported.scene.empty());
}

INSTANTIATE_TEST_SUITE_P(Each, CutMesh, testing::Range(0, 14));

struct Broken {
  const char *name, *old, *fresh, *says;
};

std::ostream& operator<<(std::ostream& out, const Broken& b) { return out << b.name; }

class BrokenGear : public testing::TestWithParam<Broken> {};

TEST_P(BrokenGear, IsAnsweredWithItsPlace) {
  const ImportedSample read(changed(kHostileGear, GetParam().old, GetParam().fresh), kHostileMesh);
  const formats::Diagnostics& said = read.read.diagnostics;
  ASSERT_GE(said.errors(), 1);
  EXPECT_NE(said.render(false).find(GetParam().says), std::string::npos) << said.render(false);
  EXPECT_TRUE(read.imported.scene.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Each, BrokenGear,
    testing::Values(
        Broken{"NoPlane", "axis: 3", "axis: 7", "gear.don:1:38: error: the axis normal to the drawing is 7"},
        Broken{"BlankPanels", "panels number: 1", "panels number: one",
               "gear.don:2:15: error: the number of panels is blank"},
        Broken{"NegativePanels", "panels number: 1", "panels number: -1",
               "the number of panels is outside [0"},
        Broken{"ABillionPanels", "panels number: 1", "panels number: 1000000000",
               "the number of panels is outside [0"},
        Broken{"TenMillionCables", "Cables number: 3", "Cables number: 10000000", "error:"},
        Broken{"ABillionCorners", "around: 4", "around: 999999999", "the number of corners is outside"},
        Broken{"MoreCorners", "around: 4", "around: 5", "a number is expected here"},
        Broken{"FewerCorners", "around: 4", "around: 2", "a panel with 2 corners"},
        Broken{"ALetterInACorner", "2 3 3 0 12 0 5 2", "2 3 x 0 12 0 5 2",
               "gear.don:8:5: error: a number is expected here: a coordinate"},
        Broken{"NaN", "Unstretched length (m): 3.1", "Unstretched length (m): nan", "and \"nan\" is none"},
        Broken{"Infinity", "Unstretched length (m): 3.1", "Unstretched length (m): -inf",
               "and \"inf\" is none"},
        Broken{"Hexadecimal", "Unstretched length (m): 3.1", "Unstretched length (m): 0x10", "hexadecimal"},
        Broken{"TooLarge", "Unstretched length (m): 3.1", "Unstretched length (m): 1e999", "is too large"},
        Broken{"NoLength", "Unstretched length (m): 3.1", "Unstretched length (m): 0",
               "the length of the cable = 0 is outside"},
        Broken{"NegativeDensity", "Volumic mass (kg/m3): 1300", "Volumic mass (kg/m3): -5",
               "the density of the cable = -5 is outside"},
        Broken{"ThickTwines", "diameter (m): 0.003", "diameter (m): 300",
               "the diameter of twines = 300 is outside"},
        Broken{"Hexagons", "hexagonal panels number: 0", "hexagonal panels number: 2",
               "hexagonal panels cannot be imported"},
        Broken{"SlidingCables", "Sliding cables number: 0", "Sliding cables number: 1",
               "sliding cables cannot be imported"},
        Broken{"NoSuchCable", "sphere_element 2 6", "sphere_element 20 6", "there is no cable 20"},
        Broken{"ArgumentsMissing", "sphere_element 2 6 0.1 3.5", "sphere_element 2 6",
               "a number is expected here: an argument of sphere_element"},
        Broken{"FewerTypes", "types of nodes: 5", "types of nodes: 4", "error:"},
        Broken{"NoTypes", "types of nodes: 5", "types of nodes: 0", "error:"}),
    [](const auto& broken) { return broken.param.name; });

class BrokenMesh : public testing::TestWithParam<Broken> {};

TEST_P(BrokenMesh, IsAnsweredWithItsPlace) {
  const ImportedSample read(kHostileGear, changed(kHostileMesh, GetParam().old, GetParam().fresh));
  const formats::Diagnostics& said = read.read.diagnostics;
  ASSERT_EQ(said.errors(), 1) << said.render(false);
  EXPECT_NE(said.render(false).find(GetParam().says), std::string::npos) << said.render(false);
}

INSTANTIATE_TEST_SUITE_P(
    Each, BrokenMesh,
    testing::Values(Broken{"ABillionNodes", "Nombre de noeuds\n   7", "Nombre de noeuds\n   1000000000",
                           "gear.mdg:5:4: error: the number of nodes is 1000000000"},
                    Broken{"NegativeNodes", "Nombre de noeuds\n   7", "Nombre de noeuds\n   -7",
                           "the number of nodes is -7"},
                    Broken{"FewerNodes", "Nombre de noeuds\n   7", "Nombre de noeuds\n   6",
                           "there are more rows than were announced"},
                    Broken{"MoreNodes", "Nombre de noeuds\n   7", "Nombre de noeuds\n   8",
                           "are in a row of nodes"},
                    Broken{"NoNumber", "3.000000", "3.0x", "is no number"},
                    Broken{"FarAway", "3.000000", "3e12", "is beyond a million"}),
    [](const auto& broken) { return broken.param.name; });

TEST(StaleMesh, IsRefusedWithItsRow) {
  const std::string bars = sample("01_two_bars.mdg");
  const auto refused = [&](const std::string& fresh) {
    const ImportedSample read(sample("01_two_bars.don"),
                              changed(bars, "2     2     3 0.5000000 1.0000000     1", fresh));
    return read.read.diagnostics.render(false);
  };
  EXPECT_NE(refused("2 2 3 0 1 0").find("gear.mdg:16:15: error: this bar is of cable 0"), std::string::npos)
      << refused("2 2 3 0 1 0");
  EXPECT_NE(refused("2 2 3 35 -25 1").find("are 35 and -25; they must grow from 0 to 1"), std::string::npos);
  EXPECT_NE(refused("2 2 3 0 1 2").find("cable 2 does not exist"), std::string::npos);
  EXPECT_NE(refused("2 2 9 0 1 1").find("node 9 does not exist"), std::string::npos);
  EXPECT_NE(refused("2 3 3 0 1 1").find("begins and ends at the same node"), std::string::npos);
  EXPECT_NE(refused("3 2 3 0 1 1").find("must be number 2, and is 3"), std::string::npos);
  EXPECT_NE(refused("2 2 3 0 1 -1").find("cable -1 does not exist"), std::string::npos);
}

/// Changes, removes and doubles random characters, with a fixed seed. Nothing may crash, and a file that is
/// imported gives a mesh that can be read again.
TEST(MutatedGears, DoNotCrash) {
  std::mt19937 random(20240607);
  const std::string letters = "0123456789.-+eE:# \n\tinputxyz\xC3";
  for (int round = 0; round < 600; ++round) {
    std::string texts[2] = {kHostileGear, kHostileMesh};
    for (int change = static_cast<int>(random() % 6); change >= 0; --change) {
      std::string& text = texts[random() % 2];
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = letters[random() % letters.size()];
          break;
        case 1:
          text.erase(at, random() % 40);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 40));
      }
    }
    const ImportedSample read(texts[0], texts[1]);
    if (read.imported.scene.empty() || read.read.diagnostics.errors()) continue;
    formats::Diagnostics again;
    const std::string mesh = formats::mesh_text(read.imported.mesh, "");
    formats::read_mesh(mesh, again.add_source("gear.mesh", mesh), again);
    ASSERT_EQ(again.errors(), 0) << again.render(false);
  }
}

}  // namespace
}  // namespace netloft::scenes::femnet
