// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/part_choice.hpp"

#include "io/formats/toml/parse.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "tests/unit/io/gears/catalogue/folder.hpp"

#include <gtest/gtest.h>

namespace netloft::gears {
namespace {

/// Reads a line `twine = …` of a scene, with a catalogue that has one twine, "thin".
struct Bench {
  explicit Bench(const std::string& line) {
    folder.write("twines.toml", kTwine);
    catalogue = Catalogue::load({folder.path()}, diagnostics);
    root = *formats::parse_toml(line, diagnostics.add_source("scene.toml", line), diagnostics);
    said = &root.as<formats::Table>()->find("twine")->value;
  }
  const CataloguePart* choose() {
    return choose_part(*said, {"twine"}, "parts.net.twine", catalogue, diagnostics);
  }
  TestFolder folder;
  formats::Diagnostics diagnostics;
  Catalogue catalogue;
  formats::Value root;
  formats::Value* said = nullptr;
};

bool anything(const std::string&) { return true; }

TEST(PartChoice, ANameStandsForAllNumbersOfThePart) {
  Bench bench("twine = \"thin\"");
  const CataloguePart* part = bench.choose();
  ASSERT_TRUE(part);
  const formats::Value spelled = spell_out(*bench.said, *part, anything);
  formats::TableReader reader(spelled, bench.diagnostics);
  EXPECT_DOUBLE_EQ(reader.real("diameter", {.unit = "m"}), 0.002);
  EXPECT_DOUBLE_EQ(reader.real("EA", {.unit = "N"}), 4000);
}

TEST(PartChoice, OneNumberIsOverriddenInPlace) {
  Bench bench("twine = { part = \"thin\", diameter = \"2.2 mm\" }");
  const formats::Value spelled = spell_out(*bench.said, *bench.choose(), anything);
  formats::TableReader reader(spelled, bench.diagnostics);
  EXPECT_DOUBLE_EQ(reader.real("diameter", {.unit = "m"}), 0.0022);
  EXPECT_DOUBLE_EQ(reader.real("EA", {.unit = "N"}), 4000);
  EXPECT_FALSE(spelled.as<formats::Table>()->find("part"));
}

TEST(PartChoice, NumbersThatNobodyWantsAreLeftOut) {
  Bench bench("twine = \"thin\"");
  const formats::Value spelled =
      spell_out(*bench.said, *bench.choose(), [](const std::string& key) { return key == "EA"; });
  EXPECT_EQ(spelled.as<formats::Table>()->members.size(), 1u);
}

TEST(PartChoice, ATableWithoutAPartIsNoChoice) {
  Bench bench("twine = { diameter = 1 }");
  EXPECT_FALSE(names_a_part(*bench.said));
}

TEST(PartChoice, ANearNameIsProposed) {
  Bench bench("twine = \"thim\"");
  EXPECT_FALSE(bench.choose());
  const std::string text = bench.diagnostics.render(false);
  EXPECT_NE(text.find("scene.toml:1:9: error: parts.net.twine: there is no twine \"thim\" in the catalogue"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("did you mean \"thin\"?"), std::string::npos) << text;
}

TEST(PartChoice, AFarNameIsAnsweredWithTheFolders) {
  Bench bench("twine = \"something-else\"");
  EXPECT_FALSE(bench.choose());
  EXPECT_NE(bench.diagnostics.render(false).find(bench.folder.path().string()), std::string::npos);
}

TEST(PartChoice, APartOfAnotherKindIsNamedAsSuch) {
  Bench bench("twine = \"thin\"");
  EXPECT_FALSE(
      choose_part(*bench.said, {"rope", "wire"}, "parts.line.rope", bench.catalogue, bench.diagnostics));
  const std::string text = bench.diagnostics.render(false);
  EXPECT_NE(text.find("there is no rope or wire"), std::string::npos) << text;
  EXPECT_NE(text.find("\"thin\" is a twine"), std::string::npos) << text;
}

TEST(PartChoice, ATableThatNamesNoPartIsRefused) {
  Bench bench("twine = {}");
  EXPECT_FALSE(bench.choose());
  EXPECT_NE(bench.diagnostics.render(false).find("is a text"), std::string::npos);
}

TEST(PartChoice, ANameThatIsNoTextIsRefused) {
  Bench bench("twine = { part = 4 }");
  EXPECT_FALSE(bench.choose());
  EXPECT_NE(bench.diagnostics.render(false).find("is a text"), std::string::npos);
}

}  // namespace
}  // namespace netloft::gears
