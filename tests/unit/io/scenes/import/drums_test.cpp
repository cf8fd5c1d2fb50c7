// SPDX-License-Identifier: BSD-3-Clause
//
// Drums change the lengths of bars as in FEMNET's output, and parts of the scene have these lengths.
#include "tests/unit/io/scenes/import/samples.hpp"

#include <algorithm>
#include <array>

namespace netloft::scenes::femnet {
namespace {

const std::string kGear = sample("09_hauling.don"), kMesh = sample("09_hauling.mdg");

ImportedSample moving(const std::string& gear) { return {gear, kMesh, Sought::motion}; }

double at(const HauledBar& bar, double time) {
  const auto after = static_cast<std::size_t>(std::lower_bound(bar.times.begin(), bar.times.end(), time) -
                                              bar.times.begin());
  if (after == 0 || after == bar.times.size()) return bar.shares[after == 0 ? 0 : after - 1];
  const double part = (time - bar.times[after - 1]) / (bar.times[after] - bar.times[after - 1]);
  return bar.shares[after - 1] + part * (bar.shares[after] - bar.shares[after - 1]);
}

/// Lengths from rest_lengths_m of 09_hauling.expected.json. The file has no length at 10 s; the test uses the
/// last length minus one time step of hauling.
TEST(Drums, LeaveTheLengthsThatFemnetPrints) {
  const ImportedSample gear(kGear, kMesh);
  const auto hauled = haul(gear.read.gear, gear.mesh);
  ASSERT_TRUE(hauled);
  ASSERT_EQ(hauled->size(), 2u);
  const HauledBar &first = hauled->at(0), &second = hauled->at(1);
  const double there[][3] = {{0.5, 1.9745, 2},      {1.5, 1.7735, 2},    {2.51, 1.394, 2},
                             {5.51, 0.194, 2},      {6.01, 0.05, 1.944}, {8.01, 0.05, 1.14402},
                             {9.51, 0.05, 0.77352}, {10, 0.05, 0.75}};
  for (const auto& [time, a, b] : there) {
    EXPECT_NEAR(2 * at(first, time), a, kHauledWithin) << time;
    EXPECT_NEAR(2 * at(second, time), b, kHauledWithin) << time;
  }
}

/// From 1 s on the drum pays out 0.4 m/s. The bar at the far end grows to 2.3 m, and then the next bar.
TEST(Drums, PayOutAtTheOtherEnd) {
  const std::string paid =
      changed(changed(kGear, "0 2 8 12", "0 1 1.01 9"), "0 0.4 0.4 -0.4", "0 0 -0.4 -0.4");
  const ImportedSample gear(changed(paid, "0.05 4.0 4", "0.05 2.3 4"), kMesh);
  const auto hauled = haul(gear.read.gear, gear.mesh);
  ASSERT_TRUE(hauled);
  ASSERT_EQ(hauled->size(), 4u);
  for (const auto& bar : *hauled) EXPECT_EQ(bar.bar, bar.number);
  EXPECT_NEAR(2 * at(hauled->at(3), 1.51), 2.2, 0.005);
  EXPECT_NEAR(2 * at(hauled->at(3), 5), 2.3, kHauledWithin);
  EXPECT_NEAR(2 * at(hauled->at(2), 2.135), 2.15, 0.005);
  EXPECT_NEAR(2 * at(hauled->at(0), 9), 2.3, kHauledWithin);
}

TEST(Drums, MakePartsOfTheirOwnOfTheBarsThatTheyHaul) {
  const auto gear = moving(kGear);
  for (const char* name : {"cable-1", "cable-1-bar-1", "cable-1-bar-2"}) {
    EXPECT_TRUE(gear.imported.mesh.find(name)) << name;
    EXPECT_TRUE(gear.holds("[parts." + std::string(name) + "]\ntype = \"rope/bar\"")) << name;
  }
  EXPECT_TRUE(gear.holds("length_share = { t = [0, 5.87, 8.0"));
  EXPECT_FALSE(gear.holds("left out"));
}

TEST(Drums, LeaveAResultOfACableThatIsHauledAsAWhole) {
  const std::string asked =
      changed(changed(kGear, "0.05 4.0 4", "1.9 2 4"), "\nTensions number: 0\n",
              "\nTensions number: 1\nTension: 1 comment: #warp# element: 1 node: 1 decimal: 2\n");
  const auto gear = moving(asked);
  EXPECT_FALSE(gear.imported.mesh.find("cable-1"));
  EXPECT_TRUE(gear.holds("warp = { of = \"cable-1-bar-1\", take = \"max tension\" }")) << gear.imported.scene;
}

TEST(Drums, ThatCannotBeAreErrors) {
  for (const auto& [old, fresh, says] : {std::array{"1 0.05 4.0 4", "2 0.05 4.0 4", "there is no cable 2"},
                                         {"1 0.05 4.0 4", "1 0 4.0 4", "must be above zero"},
                                         {"1 0.05 4.0 4", "1 5 4.0 4", "must be above zero"},
                                         {"1 0.05 4.0 4", "1 0.05 4.0 0", "a table of 0 times"},
                                         {"1 0.05 4.0 4", "1 0.05 4.0 100000", "a table of 100000 times"},
                                         {"0 2 8 12", "0 8 2 12", "its times do not ascend"},
                                         {"1 1 1 1", "1 1 3 1", "a drum is at end 1 or 2"},
                                         {"1 1 1 1", "1 1", "an end of a cable"}}) {
    const ReadGear read(changed(kGear, old, fresh));
    EXPECT_EQ(read.diagnostics.errors(), 1) << says;
    EXPECT_TRUE(read.says(says)) << read.diagnostics.render(false);
    EXPECT_TRUE(read.says("gear.don:10")) << read.diagnostics.render(false);
  }
}

TEST(Drums, ThatTakeTooManyStepsAreLeftOut) {
  const auto gear = moving(changed(kGear, "Time step (s): 0.01", "Time step (s): 1e-9"));
  EXPECT_TRUE(gear.holds("# left out, line 102, the drum of cable 1: takes too many steps"));
}

TEST(Drums, DoNotBendWhatTheyHaul) {
  EXPECT_TRUE(
      moving(kGear + "\ninput EI_flexion_cable 1 5\n")
          .holds("the drum of cable 1: the cable has bending stiffness, except where the drum shortens it"));
}

TEST(MovedNodes, StandStillAfterTheirTimes) {
  const auto gear = moving(kGear + "\ninput speed_type_node2 1 2 1 3 0.5 0.7 0 0 0 -0.1\n");
  EXPECT_TRUE(gear.holds(
      "on = \"*.type-1\"\nname = \"type-1\"\nvelocity = { t = [0.99, 1, 3, 3.01], x = [0, 0.5, 0.7, "
      "0], y = [0, 0, 0, 0], z = [0, 0, -0.1, 0] }"))
      << gear.imported.scene;
  const ImportedSample still(kGear + "\ninput speed_type_node2 1 2 1 3 0.5 0.7 0 0 0 -0.1\n", kMesh);
  EXPECT_FALSE(still.holds("velocity"));
  EXPECT_TRUE(still.holds("keyword speed_type_node2: is left out, because the scene is at rest"));
}

TEST(MovedNodes, MayBeFreeInTheFile) {
  const auto gear = moving(kGear + "\ninput speed_type_node2 2 2 0 3 0.5 0.7 0 0 0 0\n");
  EXPECT_TRUE(gear.holds("[[hold]]\non = \"*.type-2\"\nname = \"type-2\"\nvelocity = { t = [0, 3, 3.01]"))
      << gear.imported.scene;
}

}  // namespace
}  // namespace netloft::scenes::femnet
