// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/io/gears/catalogue/folder.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace netloft::gears {
namespace {

Catalogue load(const TestFolder& folder, formats::Diagnostics& d) {
  return Catalogue::load({folder.path()}, d);
}

std::string messages(const std::string& text) {
  TestFolder folder;
  folder.write("parts.toml", text);
  formats::Diagnostics d;
  load(folder, d);
  return d.render(false);
}

TEST(Catalogue, ReadsAPartInSI) {
  TestFolder folder;
  folder.write("twines.toml", kTwine);
  formats::Diagnostics d;
  const Catalogue catalogue = load(folder, d);
  ASSERT_EQ(d.errors(), 0) << d.render(false);
  const auto* part = catalogue.find("thin", {"twine"});
  ASSERT_TRUE(part);
  EXPECT_DOUBLE_EQ(part->numbers.at("diameter"), 0.002);
  EXPECT_DOUBLE_EQ(part->numbers.at("EA"), 4000);
  EXPECT_EQ(part->texts.at("source"), "a scale");
}

TEST(Catalogue, DensityGivesTheWeightInWaterOfTheMaterial) {
  TestFolder folder;
  folder.write("twines.toml", kTwine);
  formats::Diagnostics d;
  const Catalogue catalogue = load(folder, d);
  const auto& numbers = catalogue.find("thin", {"twine"})->numbers;
  const double round = std::numbers::pi / 4 * 0.002 * 0.002;
  const double in_water = 1.8e-3 * (1 - 1025.0 / 960);  // [kg/m] polyethylene less displaced water
  EXPECT_NEAR((numbers.at("density") - 1025) * round, in_water, 1e-15);
}

TEST(Catalogue, TheWeightInWaterOfAMetreIsOneInStandardGravity) {
  TestFolder folder;
  folder.write("ropes.toml",
               "[rope.ground]\ndiameter = \"20 mm\"\nEA = 1e6\nweight_in_water = \"28 N/m\"\nsource = \"s\"\n"
               "uncertainty = \"u\"\n");
  formats::Diagnostics d;
  const Catalogue catalogue = load(folder, d);
  ASSERT_EQ(d.errors(), 0) << d.render(false);
  const double round = std::numbers::pi / 4 * 0.02 * 0.02;
  EXPECT_NEAR((catalogue.find("ground", {"rope"})->numbers.at("density") - 1025) * round * 9.80665, 28,
              1e-12);
}

TEST(Catalogue, TheFolderNamedFirstCounts) {
  TestFolder own, library;
  own.write("mine.toml", std::string(kTwine).replace(std::string(kTwine).find("2 mm"), 4, "3 mm"));
  library.write("twines.toml", kTwine);
  formats::Diagnostics d;
  const Catalogue catalogue = Catalogue::load({own.path(), library.path()}, d);
  EXPECT_EQ(d.errors(), 0) << d.render(false);
  EXPECT_EQ(catalogue.parts().size(), 1u);
  EXPECT_DOUBLE_EQ(catalogue.find("thin", {"twine"})->numbers.at("diameter"), 0.003);
}

TEST(Catalogue, AFileStatesItsSourceOnce) {
  TestFolder folder;
  folder.write("floats.toml",
               "source = \"a tank\"\nuncertainty = \"2 %\"\n[float.round]\nbuoyancy = \"25 N\"\n");
  formats::Diagnostics d;
  const Catalogue catalogue = load(folder, d);
  ASSERT_EQ(d.errors(), 0) << d.render(false);
  EXPECT_EQ(catalogue.find("round", {"float"})->texts.at("source"), "a tank");
}

TEST(Catalogue, APieceDisplacesItsMassOverItsDensity) {
  TestFolder folder;
  folder.write("weights.toml",
               "source = \"\"\nuncertainty = \"\"\n[weight.lump]\nsource = \"a scale\"\n"
               "uncertainty = \"1 %\"\nmass = \"78.5 kg\"\nmaterial_density = 7850\n");
  formats::Diagnostics d;
  const Catalogue catalogue = load(folder, d);
  ASSERT_EQ(d.errors(), 0) << d.render(false);
  EXPECT_DOUBLE_EQ(catalogue.find("lump", {"weight"})->numbers.at("volume"), 0.01);
}

TEST(Catalogue, FoldersThatDoNotExistArePassedOver) {
  formats::Diagnostics d;
  EXPECT_TRUE(Catalogue::load({"/no/such/folder"}, d).parts().empty());
  EXPECT_EQ(d.errors(), 0);
}

TEST(Catalogue, APartWithoutSourceIsRefused) {
  EXPECT_NE(messages("[float.round]\nbuoyancy = 25\nuncertainty = \"1 %\"\n").find("source"),
            std::string::npos);
}

TEST(Catalogue, AnUnknownKindIsRefused) {
  EXPECT_NE(messages("[twins.thin]\ndiameter = 1\n").find("twins"), std::string::npos);
}

TEST(Catalogue, AnUnknownNumberIsRefused) {
  EXPECT_NE(messages(std::string(kTwine) + "colour = 3\n").find("unknown key \"colour\" in twine.thin"),
            std::string::npos);
}

TEST(Catalogue, ANumberOutsideItsRangeIsLocated) {
  const std::string text = messages(
      "[twine.t]\ndiameter = \"-2 mm\"\nEA = 1\ndensity = 1000\nsource = \"s\"\nuncertainty = \"u\"\n");
  EXPECT_NE(text.find("parts.toml:2:12"), std::string::npos) << text;
  EXPECT_NE(text.find("twine.t.diameter"), std::string::npos) << text;
}

TEST(Catalogue, AWrongUnitIsLocated) {
  EXPECT_NE(messages(std::string(kTwine) + "breaking_load = \"3 kg/m3\"\n").find("breaking_load"),
            std::string::npos);
}

TEST(Catalogue, ALineWithoutAWeightIsRefused) {
  const std::string text =
      messages("[rope.r]\ndiameter = 0.01\nEA = 1\nsource = \"s\"\nuncertainty = \"u\"\n");
  EXPECT_NE(text.find("mass and material_density"), std::string::npos) << text;
}

TEST(Catalogue, AMassTooLargeForItsDiameterIsRefused) {
  const std::string text = messages(
      "[rope.r]\ndiameter = 0.01\nEA = 1\nmass = 1\nmaterial_density = 500\nsource = \"s\"\nuncertainty = "
      "\"u\"\n");
  EXPECT_NE(text.find("does not fit into the diameter"), std::string::npos) << text;
}

TEST(Catalogue, APieceWithoutAWeightIsRefused) {
  EXPECT_NE(messages("[float.f]\ndiameter = 0.2\nsource = \"s\"\nuncertainty = \"u\"\n").find("buoyancy"),
            std::string::npos);
}

TEST(Catalogue, TheSamePartTwiceInAFolderIsRefused) {
  TestFolder folder;
  folder.write("a.toml", kTwine).write("b.toml", kTwine);
  formats::Diagnostics d;
  load(folder, d);
  EXPECT_NE(d.render(false).find("twice"), std::string::npos);
}

TEST(Catalogue, APartThatIsNoTableIsRefused) {
  EXPECT_NE(messages("[twine]\nthin = 3\n").find("twine.thin"), std::string::npos);
}

}  // namespace
}  // namespace netloft::gears
