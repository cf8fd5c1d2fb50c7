// SPDX-License-Identifier: BSD-3-Clause
//
// Compares figures of gears with closed forms. The scenes have no net plan; the tests declare which parts are
// panels and ropes of a gear.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/results/text/result_text.hpp"
#include "tests/folders.hpp"
#include "tests/unit/io/results/figures/hand_made.hpp"

namespace netloft::results {
namespace {

/// A scene with a headline at z = -10 m and a footrope at z = -14 m, straight from y = y0 to 3 m. With three
/// bars, no node is in the middle.
std::string mouth(const std::string& y0, const std::string& length, const std::string& water,
                  const std::string& more = "") {
  const std::string rope = "type = \"rope/bar\"\ncells = 3\nlength = " + length +
                           "\nrope = { diameter = 0.02, EA = 1e5, density = 2000 }\n";
  return "[water]\n" + water + "\n[parts.headline]\n" + rope + "sketch = [[50, " + y0 +
         ", -10], [50, 3, -10]]\n[parts.footrope]\n" + rope + "sketch = [[50, " + y0 +
         ", -14], [50, 3, -14]]\n" + more +
         "[[hold]]\non = \"headline\"\n[[hold]]\non = \"footrope\"\n[analysis]\nsolver = \"newton\"\n";
}

const HandMade::Parts kRopes{{}, {"headline", "footrope"}, {}};
constexpr double kExact = 1e-12;

TEST(GearMouth, OfARectangleIsItsHeightSpreadAndArea) {
  const auto gear = HandMade(written(mouth("-3", "6", "current = [1, 0, 0]")), kRopes).at_start();
  EXPECT_NEAR(value(gear, "mouth/headline_height"), 4, kExact);
  EXPECT_NEAR(value(gear, "mouth/upper_wing_spread"), 6, kExact);
  EXPECT_NEAR(value(gear, "mouth/lower_wing_spread"), 6, kExact);
  EXPECT_NEAR(value(gear, "mouth/area"), 24, 24 * kExact);
}

TEST(GearMouth, IsSeenAlongTheCurrent) {
  const auto askew = HandMade(written(mouth("-3", "6", "current = [1, 1, 0]")), kRopes).at_start();
  EXPECT_NEAR(value(askew, "mouth/area"), 24 / std::numbers::sqrt2, 24 * kExact);
  const auto still = HandMade(written(mouth("-3", "6", "")), kRopes).at_start();
  EXPECT_NEAR(value(still, "mouth/area"), 24, 24 * kExact);
}

TEST(GearMouth, OfAHalfIsThatOfTheWhole) {
  HandMade::Parts half = kRopes;
  half.times = 2;
  const auto gear = HandMade(written(mouth("0", "3", "current = [1, 0, 0]")), half).at_start();
  EXPECT_NEAR(value(gear, "mouth/headline_height"), 4, kExact);
  EXPECT_NEAR(value(gear, "mouth/upper_wing_spread"), 6, kExact);
  EXPECT_NEAR(value(gear, "mouth/area"), 24, 24 * kExact);
}

TEST(GearMouth, StandsOverTheSeabedIfThereIsOne) {
  const std::string bed =
      "[parts.bed]\ntype = \"seabed/plane\"\non = \"footrope\"\n"
      "seabed = { depth = 20, slope_x = 0.1 }\n";
  const auto gear = HandMade(written(mouth("-3", "6", "", bed)), kRopes).at_start();
  EXPECT_NEAR(value(gear, "mouth/headline_height"), -10 - (-20 + 0.1 * 50), kExact);
}

TEST(GearMouth, IsLeftOutWhereThereIsNone) {
  const auto file = written(mouth("-3", "6", ""));
  const auto none = HandMade(file, {{}, {"headline", "footrope"}, {}, "", ""}).at_start();
  EXPECT_EQ(find_scalar(none, "mouth/area"), nullptr);
  EXPECT_EQ(find_scalar(none, "mouth/headline_height"), nullptr);
  const auto upper = HandMade(file, {{}, {"headline"}, {}, "headline", ""}).at_start();
  EXPECT_EQ(find_scalar(upper, "mouth/headline_height"), nullptr);
  EXPECT_NEAR(value(upper, "mouth/upper_wing_spread"), 6, kExact);
}

/// A flat rectangle of 10 by 10 meshes, 1.2 m by 1.6 m. Bars of 0.1 m are just taut: half a mesh is 0.06 m
/// wide and 0.08 m long.
const std::string kNetting = R"(
[water]
density = 1000
gravity = 10
current = [1, 0, 0]
[parts.wall]
type = "priour/triangle"
panel = { across = 10, along = 10, bar = 0.1 }
cells = [3, 5]
twine = { diameter = 0.002, EA = 1e4, density = 1140 }
sketch = [[0, -0.6, 0], [0, 0.6, 0], [0, 0.6, -1.6], [0, -0.6, -1.6]]
[[hold]]
on = "wall.fore"
[analysis]
solver = "newton"
)";

TEST(GearNetting, IsAsOpenAndAsLargeAsItIsSpread) {
  const auto gear = HandMade(written(kNetting), {{"wall"}, {}, {}}).at_start();
  for (const char* how : {"min", "mean", "max"})
    EXPECT_NEAR(value(gear, std::string("panels/wall/opening_") + how), 0.6, 1e-12) << how;
  EXPECT_NEAR(value(gear, "panels/wall/area"), 1.2 * 1.6, 1e-12);
  EXPECT_NEAR(value(gear, "panels/wall/filtered_area"), 1.2 * 1.6, 1e-12);
}

// Each of the 10 by 10 meshes has 2 knots, and each knot 2 bars: 400 bars of 0.1 m.
TEST(GearNetting, HasTheTwineThatIsCounted) {
  const auto gear = HandMade(written(kNetting), {{"wall"}, {}, {}}).at_start();
  const double length = 400 * 0.1, section = std::numbers::pi / 4 * 0.002 * 0.002;
  EXPECT_NEAR(value(gear, "panels/wall/twine_area"), length * 0.002, 1e-14);
  EXPECT_NEAR(value(gear, "panels/wall/mass"), length * section * 1140, 1e-12);
  EXPECT_NEAR(value(gear, "netting/mass"), length * section * 1140, 1e-12);
  EXPECT_NEAR(value(gear, "weight_in_water/netting"), length * section * 140 * 10, 1e-11);
}

TEST(GearNetting, FiltersWhatItTurnsToTheCurrent) {
  // A current at 60 degrees from the normal of the netting.
  const std::string at60 = "water.current=[0.5, 0.8660254037844386, 0]";
  const auto gear = HandMade(written(kNetting), {{"wall"}, {}, {}}, {at60}).at_start();
  EXPECT_NEAR(value(gear, "panels/wall/filtered_area"), 1.2 * 1.6 / 2, 1e-12);
  EXPECT_NEAR(value(gear, "panels/wall/area"), 1.2 * 1.6, 1e-12);
}

TEST(GearNetting, OfAHalfCountsTwice) {
  HandMade::Parts half{{"wall"}, {}, {}};
  half.times = 2;
  const auto one = HandMade(written(kNetting), {{"wall"}, {}, {}}).at_start();
  const auto both = HandMade(written(kNetting), half).at_start();
  for (const char* name : {"panels/wall/area", "netting/mass", "weight_in_water/all", "drag/all/x"})
    EXPECT_NEAR(value(both, name), 2 * value(one, name), 1e-12 * value(both, name)) << name;
  EXPECT_EQ(value(both, "panels/wall/opening_mean"), value(one, "panels/wall/opening_mean"));
}

TEST(GearForces, WeighFloatsAgainstWeights) {
  const std::string pieces = R"(
[parts.floats]
type = "float/float"
on = "headline"
number = 6
float = { buoyancy = 25 }
[parts.weights]
type = "float/float"
on = "footrope"
number = 4
float = { buoyancy = -30 }
)";
  HandMade::Parts parts = kRopes;
  parts.pieces = {"floats", "weights"};
  const auto gear =
      HandMade(written(mouth("-3", "6", "density = 1000\ngravity = 10", pieces)), parts).at_start();
  const double rope = std::numbers::pi / 4 * 0.02 * 0.02 * 6 * (2000 - 1000) * 10;
  EXPECT_NEAR(value(gear, "weight_in_water_by_part/floats"), -150, 1e-12);
  EXPECT_NEAR(value(gear, "weight_in_water/floats"), 120 - 150, 1e-12);
  EXPECT_NEAR(value(gear, "weight_in_water/ropes"), 2 * rope, 1e-12);
  EXPECT_NEAR(value(gear, "budget/sinking"), 2 * rope + 120, 1e-12);
  EXPECT_NEAR(value(gear, "budget/floating"), -150, 1e-12);
  EXPECT_NEAR(value(gear, "weight_in_water/all"), 2 * rope - 30, 1e-12);
  EXPECT_NEAR(value(gear, "ropes/headline/mass"), std::numbers::pi / 4 * 0.02 * 0.02 * 6 * 2000, 1e-12);
}

// The footrope has three bars of 2 m, and two of its nodes are in the bed: three of six bar ends, which is
// half, touch the bed.
TEST(GearGround, IsTouchedByAShareOfTheFootrope) {
  const std::string bed =
      "[parts.bed]\ntype = \"seabed/plane\"\non = \"footrope\"\n"
      "seabed = { depth = 14, slope_y = -0.01, stiffness = 1e4, softness = 1e-6 }\n";
  const auto gear = HandMade(written(mouth("-3", "6", "", bed)), kRopes).at_start();
  EXPECT_NEAR(value(gear, "ground/footrope_fraction"), 0.5, kExact);
  // The nodes at y = -3 and -1 represent 1 m and 2 m of rope, and are 3 cm and 1 cm deep, less half of
  // `softness`.
  const double n_z = 1 / std::hypot(1, 0.01), depths = (0.03 + 2 * 0.01) * n_z - 3 * 0.5e-6;
  EXPECT_NEAR(value(gear, "ground/force"), 1e4 * depths, 1e-8);
}

double tension_error(int bars) {
  const std::string cells = "parts.rope.cells=" + std::to_string(bars);
  HandMade rope(netloft::test::source_folder() + "/gear-library/scenes/hanging-rope.toml",
                {{}, {"rope"}, {}, "", ""}, {cells});
  const auto gear = rope.solved().figures;
  EXPECT_NEAR(value(gear, "ropes/rope/tension_start"), value(gear, "ropes/rope/tension_end"), 1e-7);
  return value(gear, "ropes/rope/tension_end") - 5.82945518;  // exact (Irvine), as the scene says
}

TEST(GearRopes, OfACatenaryEndWithItsTension) {
  const double coarse = tension_error(20), fine = tension_error(40);
  EXPECT_LT(std::abs(fine), 2e-3);
  EXPECT_NEAR(coarse / fine, 4, 0.5);  // second order
}

const std::vector<std::string> kPanels = {"upper1", "upper2", "upper3", "upper4",
                                          "lower1", "lower2", "lower3", "lower4"};

/// The figures of the small trawl, modelled as a half or whole.
HandMade small_trawl(const std::string& model) {
  HandMade::Parts parts{kPanels, {"headline", "footrope", "starboard-upper-bridle"}, {"floats", "weights"}};
  parts.times = model == "whole" ? 1 : 2;
  return {netloft::test::source_folder() + "/gear-library/scenes/validation/small-trawl/" + model + ".toml",
          parts};
}

/// Whether a figure must be equal for the half and the whole model. Sums over the port bridles, which the
/// half model lacks, and forces across the gear differ.
bool is_comparable(const std::string& name) {
  for (const char* other : {"bridle", "/y", "others", "headline/tension_start", "footrope/tension_start"})
    if (name.find(other) != std::string::npos) return false;
  return name.find("drag/") == std::string::npos && name.find("weight_in_water/") == std::string::npos;
}

// The whole model is the half model and its mirror image, so that figures differ only by the tolerance of the
// solver.
TEST(GearFigures, OfAHalfAreThoseOfTheWhole) {
  const auto half = small_trawl("half").solved().figures, whole = small_trawl("whole").solved().figures;
  int compared = 0;
  for (const auto& f : whole) {
    if (!is_comparable(f.name)) continue;
    EXPECT_NEAR(value(half, f.name), f.value, 1e-5 * (1 + std::abs(f.value))) << f.name;
    ++compared;
  }
  EXPECT_GT(compared, 80);
  for (const char* name : {"drag/netting/x", "drag/all/x", "weight_in_water/all", "budget/floating"})
    EXPECT_NEAR(value(half, name), value(whole, name), 1e-5 * (1 + std::abs(value(whole, name)))) << name;
}

TEST(GearFigures, ComeWithTheSolversError) {
  const auto gear = small_trawl("half").solved().figures;
  for (const auto& f : gear) {
    EXPECT_GE(f.solver_error, 0) << f.name;
    EXPECT_LT(f.solver_error, 1e-4 * (1 + std::abs(f.value))) << f.name;
  }
}

TEST(GearFigures, AddUp) {
  const auto gear = small_trawl("half").solved().figures;
  for (const char* axis : {"x", "y", "z"}) {
    double parts = 0;
    for (const auto& f : gear)
      if (f.name.starts_with("drag_by_part/") && f.name.ends_with(axis)) parts += f.value;
    EXPECT_NEAR(value(gear, std::string("drag/all/") + axis), parts, 1e-9);
  }
  EXPECT_NEAR(value(gear, "weight_in_water/all"),
              value(gear, "budget/sinking") + value(gear, "budget/floating"), 1e-9);
}

TEST(GearFigures, AreNoneOfASceneWithoutAGear) {
  runs::PreparedScene plain(
      {netloft::test::source_folder() + "/gear-library/scenes/hanging-rope.toml", {}, 1},
      netloft::test::shipped_plugins());
  ASSERT_EQ(plain.prepare(), runs::PreparedScene::State::ready);
  const auto& scene = plain.loaded().scene;
  EXPECT_TRUE(find_figures(plain.loaded(), plain.assembler(),
                           ask_elements(scene, plain.assembler(), plain.assembler().start()))
                  .empty());
}

// Tensions within a part add up to zero, so only loads on the part are reported.
TEST(PartForces, AreLoadsAndNotTheTensionsOfMembers) {
  runs::PreparedScene taut({written(mouth("-3", "5", "current = [1, 0, 0]")), {}, 1},
                           netloft::test::shipped_plugins());
  ASSERT_EQ(taut.prepare(), runs::PreparedScene::State::ready);
  Assembler& assembler = taut.assembler();
  const auto forces = ask_elements(taut.loaded().scene, assembler, assembler.start()).forces;
  ASSERT_EQ(forces.size(), 4);
  EXPECT_EQ(std::ranges::count_if(forces, &PartForce::is_weight), 2);
  EXPECT_EQ(std::ranges::count_if(forces, &PartForce::is_drag), 2);
}

TEST(ResultText, SpeaksOfPowerAndFuelInTheUnitsOfTheTrade) {
  Result result;
  result.figures = {{"towing/power", "W", "power", 81234, 100, 0},
                    {"towing/fuel", "kg/s", "fuel", 0.015},
                    {"towing/fuel_per_area", "kg/m2", "fuel", 4e-4},
                    {"power/netting", "W", "of it", 40500}};
  const std::string text = result_text(result);
  for (const char* line :
       {"81.23 ± 0.10 kW", " 54 kg/h", " 4 kg/ha", "[kW]\n    netting                     40.500\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

}  // namespace
}  // namespace netloft::results
