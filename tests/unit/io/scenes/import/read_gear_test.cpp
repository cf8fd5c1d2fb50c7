// SPDX-License-Identifier: BSD-3-Clause
//
// The lexical rules of a .don and its keywords, on small gears that FEMNET reads.
#include "tests/unit/io/scenes/import/samples.hpp"

#include <cmath>
#include <numbers>

namespace netloft::scenes::femnet {
namespace {

const std::string kBars = sample("01_two_bars.don");

std::string with_tail(const std::string& tail) { return kBars + "\n" + tail + "\n"; }

TEST(FemnetGear, IsReadFieldByField) {
  const ReadGear read(kBars);
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.diagnostics.render(false);
  ASSERT_EQ(read.gear.cables.size(), 1u);
  const Cable& c = read.gear.cables[0];
  EXPECT_EQ(c.ends[1].at, (Triple{8, 0, -10}));
  EXPECT_EQ(c.EA, 50000);
  EXPECT_EQ(c.EA_compression, 10);
  EXPECT_EQ(c.length, 10);
  EXPECT_EQ(c.density, 1300);
  EXPECT_EQ(c.diameter, 0.02);
  EXPECT_EQ(c.cd, 1.2);
  EXPECT_EQ(c.friction, 0.08);
  ASSERT_EQ(read.gear.types.size(), 2u);
  EXPECT_EQ(read.gear.types[0].fixed, (Triple{1, 1, 1}));
  EXPECT_EQ(read.gear.environment.direction, 30);
  EXPECT_EQ(read.gear.environment.speed, 1.5);
  ASSERT_EQ(read.gear.wanted.size(), 2u);
  EXPECT_EQ(read.gear.wanted[1].text, "middle z (m)");
  EXPECT_EQ(read.gear.wanted[1].first, 2);
  EXPECT_EQ(read.gear.wanted[1].second, 3);
}

TEST(FemnetGear, KeepsNumbersOfPanelsInSinglePrecision) {
  const ReadGear read(sample("03_node_force_symmetry.don"));
  ASSERT_EQ(read.diagnostics.errors(), 0);
  const Panel& p = read.gear.panels.at(0);
  EXPECT_EQ(p.side, static_cast<double>(0.2f));
  EXPECT_EQ(p.diameter, static_cast<double>(0.003f));
  EXPECT_EQ(p.corners.size(), 4u);
  EXPECT_EQ(p.corners[2].U, 12);
  EXPECT_EQ(p.corners[2].V, -8);
  EXPECT_EQ(read.gear.cables[0].diameter, 0.012);  // not rounded to single precision
}

TEST(FemnetGear, TakesValuesBehindColonsWhateverTheWordsAndLines) {
  const ReadGear read(
      changed(kBars, "Traction stiffness (N): 50000\n", "Raideur\nde\n traction (N) :\n\n   5.E4 "));
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.diagnostics.render(false);
  EXPECT_EQ(read.gear.cables[0].EA, 50000);
  EXPECT_EQ(read.gear.cables[0].EA_compression, 10);
}

TEST(FemnetGear, IsTheSameWithTheLineEndsOfOtherSystems) {
  std::string windows, mac = kBars;
  for (const char c : kBars) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  for (char& c : mac)
    if (c == '\n') c = '\r';
  for (const auto& text : {windows, mac}) {
    const ReadGear read(text);
    ASSERT_EQ(read.diagnostics.errors(), 0) << read.diagnostics.render(false);
    EXPECT_EQ(read.gear.cables[0].length, 10);
    EXPECT_EQ(read.gear.environment.water_density, 1000);
  }
}

TEST(FemnetGear, ReadsLabelsOfAnyEncoding) {
  const ReadGear read("\xEF\xBB\xBF" + changed(kBars, "Traction stiffness", "Rigidit\xE9 \xC3\xA9"));
  ASSERT_EQ(read.diagnostics.errors(), 0);
  EXPECT_EQ(read.gear.cables[0].EA, 50000);
}

TEST(FemnetGear, ReadsNumbersOfFortran) {
  EXPECT_EQ(ReadGear(changed(kBars, "diameter (m): 0.02", "diameter (m): 2.D-2")).gear.cables[0].diameter,
            0.02);
}

TEST(FemnetGear, TakesABlankFieldAsZeroAndSaysSo) {
  const ReadGear read(changed(kBars, "Normal Cd: 1.2", "Normal Cd:"));
  ASSERT_EQ(read.diagnostics.errors(), 0);
  EXPECT_EQ(read.gear.cables[0].cd, 0);
  EXPECT_EQ(read.gear.cables[0].friction, 0.08);
  EXPECT_TRUE(read.says("the normal drag coefficient of a cable is blank, and taken as 0"));
}

TEST(FemnetGear, WarnsOfACommaThatIsNoDecimalPoint) {
  const ReadGear read(changed(kBars, "diameter (m): 0.02", "diameter (m): 0,02"));
  EXPECT_EQ(read.gear.cables[0].diameter, 0);
  EXPECT_TRUE(read.says("a comma is no decimal point"));
}

TEST(FemnetGear, StopsWholeNumbersAtTheirFirstOtherCharacter) {
  EXPECT_EQ(ReadGear(changed(kBars, "Bars number: 2", "Bars number: 3.5")).gear.cables[0].bars, 3);
}

TEST(FemnetGear, LetsTextsHoldColons) {
  const ReadGear read(changed(kBars, "#ends (m)#", "## a: b: 3 #"));
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.diagnostics.render(false);
  EXPECT_EQ(read.gear.wanted[0].text, "a: b: 3");
  EXPECT_EQ(read.gear.wanted[0].second, 3);
}

TEST(FemnetGear, TakesTheMeshingOrderAsLongAsItLasts) {
  for (const char* order : {"all", "el: 1 el: 1 el: 7", "el:1", ""}) {
    const ReadGear read(changed(kBars, "el: 1 \n", std::string(order) + "\n"));
    ASSERT_EQ(read.diagnostics.errors(), 0) << order << read.diagnostics.render(false);
    EXPECT_EQ(read.gear.types.size(), 2u) << order;
  }
}

TEST(FemnetGear, MayAnnounceWinches) {
  EXPECT_EQ(ReadGear("version_2\n" + changed(kBars, "Links number", "Winches number: 0\nLinks number"))
                .diagnostics.errors(),
            0);
  EXPECT_TRUE(ReadGear("version_2\n" + changed(kBars, "Links number", "Winches number: 1\nLinks number"))
                  .says("winches"));
}

TEST(FemnetGear, TellsWhatItNeeds) {
  const auto needs = [](const std::string& text) { return features_of(ReadGear(text).gear); };
  EXPECT_EQ(needs(kBars), (std::vector<std::string>{"ropes", "another density of water"}));
  EXPECT_EQ(needs(sample("04_moving_bed.don")),
            (std::vector<std::string>{"ropes", "masses", "forces at nodes", "a bed",
                                      "a moving bed with friction"}));
  EXPECT_EQ(needs(sample("09_hauling.don")),
            (std::vector<std::string>{"ropes", "masses", "boxes", "hauling at a drum"}));
}

TEST(FemnetKeywords, ActBehindAnythingButAGluedCharacter) {
  EXPECT_EQ(ReadGear(with_tail("#input water_density 5")).gear.environment.water_density, 1000);
  EXPECT_EQ(ReadGear(with_tail("//input water_density 5")).gear.environment.water_density, 1000);
  EXPECT_EQ(ReadGear(with_tail("# input water_density 5")).gear.environment.water_density, 5);
  EXPECT_EQ(ReadGear(with_tail("input\nwater_density\n\n5")).gear.environment.water_density, 5);
}

TEST(FemnetKeywords, AreLostBehindTwoBlanks) {
  const ReadGear read(with_tail("input  water_density 5"));
  EXPECT_EQ(read.gear.environment.water_density, 1000);
  EXPECT_TRUE(read.says("exactly one blank"));
}

TEST(FemnetKeywords, ThatAreNotKnownAreSaid) {
  const ReadGear read(with_tail("input watr_density 5\ninput tarp 1 2\noutput paraview\nsome notes 1 2 3"));
  ASSERT_EQ(read.gear.findings.size(), 2u);
  EXPECT_EQ(read.gear.findings[0].kind, Finding::Kind::note);
  EXPECT_EQ(read.gear.findings[0].what, "keyword watr_density");
  EXPECT_EQ(read.gear.findings[1].kind, Finding::Kind::left_out);
}

/// The expected values are computed by hand from the volumes of rope and spheres, their masses, and the
/// frontal areas.
TEST(FemnetKeywords, SmearSpheresOnACable) {
  const double pi = std::numbers::pi, rope = 10 * pi * 0.02 * 0.02 / 4, sphere = pi * 0.1 * 0.1 * 0.1 / 6;
  const ReadGear read(with_tail("input sphere_element 1 6 0.1 3.5"));
  const Cable& c = read.gear.cables[0];
  const double d = std::sqrt(4 * (rope + 6 * sphere) / (pi * 10));
  EXPECT_NEAR(c.diameter, d, 1e-15);
  EXPECT_NEAR(c.density * (rope + 6 * sphere), 1300 * rope + 6 * (1000 * sphere - 3.5 / 9.81), 1e-9);
  EXPECT_NEAR(c.cd * 10 * d, 0.6 * 6 * pi * 0.01 / 4 + 1.2 * 10 * 0.02, 1e-12);
  EXPECT_EQ(c.friction, 0.08);
}

TEST(FemnetKeywords, AddSpheresToThoseThatAreThere) {
  const double once = ReadGear(with_tail("input sphere_element 1 6 0.1 3.5")).gear.cables[0].diameter;
  const double twice =
      ReadGear(with_tail("input sphere_element 1 6 0.1 3.5\ninput sphere_element 1 6 0.1 3.5"))
          .gear.cables[0]
          .diameter;
  EXPECT_NEAR(twice * twice - once * once, once * once - 0.02 * 0.02, 1e-12);
}

TEST(FemnetKeywords, PullWithAFoil) {
  const ReadGear read(with_tail("input foil2 2 3 0.5 2 -1"));
  const double q = 0.5 * 1000 * 3 * 1.5 * 1.5, c = std::cos(std::numbers::pi / 6), s = 0.5;
  EXPECT_NEAR(read.gear.types[1].force[0], q * (0.5 * c - 2 * s), 1e-9);
  EXPECT_NEAR(read.gear.types[1].force[1], q * (0.5 * s + 2 * c), 1e-9);
  EXPECT_NEAR(read.gear.types[1].force[2], -q, 1e-9);
}

TEST(FemnetKeywords, SpeakOfCablesThatExist) {
  const ReadGear read(with_tail("input EI_flexion_cable 2 80"));
  ASSERT_EQ(read.diagnostics.errors(), 1);
  EXPECT_TRUE(read.says("gear.don:98:7: error: EI_flexion_cable: there is no cable 2"))
      << read.diagnostics.render(false);
}

}  // namespace
}  // namespace netloft::scenes::femnet
