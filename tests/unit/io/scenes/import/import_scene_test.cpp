// SPDX-License-Identifier: BSD-3-Clause
//
// The result of importing a gear: parts, loads, holds, and messages on features without a counterpart.
#include "tests/unit/io/scenes/import/samples.hpp"

namespace netloft::scenes::femnet {
namespace {

ImportedSample imported(const std::string& name) { return {sample(name + ".don"), sample(name + ".mdg")}; }

TEST(FemnetScene, HalvesWhatStandsOnThePlaneOfSymmetry) {
  const auto gear = imported("03_node_force_symmetry");
  EXPECT_TRUE(gear.holds("[parts.force-3]\ntype = \"force/constant\"\non = \"*.type-3\"\neach = 0.5"));
  EXPECT_TRUE(gear.holds("[parts.force-5]\ntype = \"force/constant\"\non = \"*.type-5\"\neach = 1"));
  EXPECT_TRUE(gear.holds("[[hold]]\non = \"*.type-3\"\nname = \"type-3\"\naxes = \"y\""));
}

TEST(FemnetScene, TurnsTrianglesSoThatTheirOuterFaceIsSeenCounterClockwise) {
  const auto gear = imported("05_catch_front");
  const MeshFile::Triangle& there = gear.mesh.triangles.at(0);
  const formats::MeshRegion& here = *gear.imported.mesh.find("panel-1");
  EXPECT_EQ(here.nodes[0], there.nodes[0]);
  EXPECT_EQ(here.nodes[1], there.nodes[2]);
  EXPECT_EQ(here.nodes[2], there.nodes[1]);
  EXPECT_EQ(here.numbers[2], there.UV[4]);
  EXPECT_EQ(here.numbers[3], there.UV[5]);
}

TEST(FemnetScene, MakesOneBarOfSeveralTwines) {
  const auto gear = imported("06_netting2ropes");
  EXPECT_TRUE(gear.holds("type = \"lumped/net\""));
  const formats::MeshRegion& region = *gear.imported.mesh.find("panel-1");
  EXPECT_EQ(region.kind, formats::RegionKind::twines);
  EXPECT_EQ(region.numbers[0], 5);  // one bar for five mesh sides
  EXPECT_EQ(region.numbers[1], 5);
}

TEST(FemnetScene, HasNoDragOfNettingWhereTheFileWantsNone) {
  const std::string none = sample("02_netting_panel.don") + "\ninput drag_forces_type 3\n";
  EXPECT_TRUE(ImportedSample(none, sample("02_netting_panel.mdg")).holds("normal = 0, tangential = 0"));
  EXPECT_FALSE(imported("02_netting_panel").holds("normal = 0, tangential = 0"));
}

TEST(FemnetScene, ClampsCablesThatMeet) {
  const auto gear = imported("07_bending_rest_angle");
  EXPECT_TRUE(gear.holds("[parts.clamp-1]\ntype = \"rope/clamp\"\non = [\"cable-1\", \"cable-2\"]"));
  EXPECT_TRUE(gear.holds("EI = 60, angle = 1.047197551196597"));  // the smaller EI; 60 degrees
}

TEST(FemnetScene, HoldsWhatNothingHolds) {
  const std::string loose =
      changed(sample("01_two_bars.don"), "Displacement X,Y,Z: 1  1  1", "Displacement X,Y,Z: 1  0  1");
  const ImportedSample gear(loose, sample("01_two_bars.mdg"));
  EXPECT_TRUE(gear.holds("[[hold]]\non = \"*.loose-1\"\nname = \"loose-1\"\naxes = \"y\"\nloose = true"));
  EXPECT_NE(gear.imported.scene.find("# note, line 0, node 1: is held along y"), std::string::npos)
      << gear.imported.scene;
}

TEST(FemnetScene, GivesANegativeMassAsAForce) {
  const std::string light = changed(sample("01_two_bars.don"), "No du type: 2\nMass X,Y,Z (kg): 0  0  0",
                                    "No du type: 2\nMass X,Y,Z (kg): 0 0 -2");
  EXPECT_TRUE(ImportedSample(light, sample("01_two_bars.mdg")).holds("force = { z = 19.62 }"));
}

TEST(FemnetScene, AsksForWhatTheAuthorWantedPrinted) {
  EXPECT_TRUE(
      imported("01_two_bars").holds("[results]\nmiddle-z-m = { of = \"cable-1.node-1\", take = \"z\" }"));
}

TEST(FemnetScene, SaysWhatItLeavesOut) {
  const ImportedSample gear(sample("01_two_bars.don") + "\ninput tarp 1\n", sample("01_two_bars.mdg"));
  ASSERT_EQ(gear.imported.findings.size(), 1u);
  EXPECT_EQ(gear.imported.findings[0].kind, Finding::Kind::left_out);
  EXPECT_TRUE(gear.holds("# left out, line 98, keyword tarp: is not modelled here")) << gear.imported.scene;
}

const std::string kWavy = changed(sample("09_hauling.don"), "Wave height (m): 0", "Wave height (m): 2");

ImportedSample moving_sample(const std::string& gear) {
  return {gear, sample("09_hauling.mdg"), Sought::motion};
}

TEST(FemnetMotion, IsOfNoInterestAtRestAndSaid) {
  const ImportedSample gear(kWavy, sample("09_hauling.mdg"));
  EXPECT_FALSE(gear.holds("waves ="));
  EXPECT_FALSE(gear.holds("[analysis]"));
  EXPECT_TRUE(gear.holds(
      "# note, line 74, waves: are left out, because the scene is at rest; --motion writes the motion"))
      << gear.imported.scene;
}

TEST(FemnetMotion, HasTheWavesOfTheFile) {
  const auto gear = moving_sample(changed(kWavy, "Wave direction (deg.): 0", "Wave direction (deg.): 450"));
  EXPECT_TRUE(
      gear.holds("waves = { height = 2, period = 10, direction = 1.5707963267948966, depth = 100, ramp = 10, "
                 "stretching = \"none\" }"))
      << gear.imported.scene;
  EXPECT_TRUE(
      gear.holds("kind = \"dynamic\"\nstart = \"equilibrium\"\nduration = 10\noutput_interval = 0.5"));
  EXPECT_TRUE(gear.holds("mass = 40, added_mass = 10"));
}

TEST(FemnetMotion, LeavesOutWavesThatAreNotLinear) {
  for (const auto& [height, why] :
       {std::pair{"25", "they would break at"}, {"-1", "their height is not within"}}) {
    const auto gear =
        moving_sample(changed(kWavy, "Wave height (m): 2", std::string("Wave height (m): ") + height));
    EXPECT_TRUE(gear.holds("# left out, line 74, waves: " + std::string(why))) << gear.imported.scene;
    EXPECT_FALSE(gear.holds("waves ="));
  }
  EXPECT_TRUE(
      moving_sample(changed(kWavy, "Depth (m): 100", "Depth (m): 1.5")).holds("waves: they would break"));
}

/// Crests rise by a² k (3 − t²)/(4 t³) more, with t = tanh k h: a = 1 m and h = 100 m give k = 0.04044 1/m
/// and t = 0.99939.
TEST(FemnetMotion, SaysHowMuchWavesOfHigherOrderAreHigher) {
  EXPECT_TRUE(moving_sample(kWavy + "\ninput wave_model 2\n").holds("crests would rise by 0.0202 m more"))
      << moving_sample(kWavy + "\ninput wave_model 2\n").imported.scene;
}

TEST(FemnetMotion, HasDragWhereWaterAndGearMove) {
  const auto still = changed(sample("09_hauling.don"), "Current speed (m/s): 0.5", "Current speed (m/s): 0");
  EXPECT_FALSE(ImportedSample(still, sample("09_hauling.mdg")).holds("drag"));
  EXPECT_TRUE(moving_sample(still).holds("drag = { law = \"hydro/morison\", normal = 1.2"));
}

TEST(FemnetMotion, LeavesOutWhatMovesInAnUnknownManner) {
  const std::string wound = sample("09_hauling.don") + "\ninput winch_speed 1\n";
  EXPECT_TRUE(moving_sample(wound).holds(
      "# left out, line 108, keyword winch_speed: motion of this kind is not known here"))
      << moving_sample(wound).imported.scene;
  EXPECT_TRUE(ImportedSample(wound, sample("09_hauling.mdg"))
                  .holds("# note, line 108, keyword winch_speed: is left out, because the scene is at rest"));
}

}  // namespace
}  // namespace netloft::scenes::femnet
