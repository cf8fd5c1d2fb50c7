// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/folders.hpp"
#include "tests/folders.hpp"
#include "tests/unit/io/gears/catalogue/folder.hpp"

#include <gtest/gtest.h>

#include <set>

namespace netloft::gears {
namespace {

const Catalogue& library() {
  static formats::Diagnostics diagnostics;
  static const Catalogue catalogue =
      Catalogue::load({test::source_folder() + "/gear-library/catalogue"}, diagnostics);
  EXPECT_EQ(diagnostics.errors(), 0) << diagnostics.render(false);
  return catalogue;
}

TEST(GearLibrary, HoldsAtLeastFortyParts) { EXPECT_GE(library().parts().size(), 40u); }

TEST(GearLibrary, HasPartsOfEveryKind) {
  std::set<std::string> kinds;
  for (const auto& part : library().parts()) kinds.insert(part.kind->name);
  EXPECT_EQ(kinds.size(), part_kinds().size());
}

TEST(GearLibrary, EveryPartSaysWhereItComesFromAndHowFarItMayBeWrong) {
  for (const auto& part : library().parts()) {
    EXPECT_GT(part.texts.at("source").size(), 10u) << part.name;
    EXPECT_GT(part.texts.at("uncertainty").size(), 3u) << part.name;
  }
}

TEST(GearLibrary, NettingNamesATwineThatIsThere) {
  for (const auto& part : library().parts()) {
    if (part.kind->name != std::string("netting")) continue;
    EXPECT_TRUE(library().find(part.texts.at("twine"), {"twine"})) << part.name;
  }
}

/// A wrong digit in the library would give a stress that no material of this kind can bear.
TEST(GearLibrary, BreakingStressesAreThoseOfTheirKind) {
  for (const auto& part : library().parts()) {
    if (!part.numbers.contains("breaking_load")) continue;
    const double d = part.numbers.at("diameter"), stress = part.numbers.at("breaking_load") / (d * d);
    EXPECT_GT(stress, 8e7) << part.name;
    EXPECT_LT(stress, 1.2e9) << part.name;
  }
}

TEST(GearLibrary, SolidFillsPartOfTheRound) {
  for (const auto& part : library().parts()) {
    const auto& n = part.numbers;
    if (!n.contains("material_density") || !n.contains("EA")) continue;
    const double fraction =
        n.at("mass") / n.at("material_density") / (0.785398 * n.at("diameter") * n.at("diameter"));
    const bool is_chain = part.kind->name == std::string("chain");
    EXPECT_GT(fraction, is_chain ? 3 : 0.45) << part.name;
    EXPECT_LT(fraction, is_chain ? 4 : 0.95) << part.name;
  }
}

TEST(CatalogueFolders, TheGearLibraryIsFoundFromTheProgram) {
  formats::Diagnostics diagnostics;
  const auto folders = catalogue_folders(diagnostics, {"mine"});
  ASSERT_GE(folders.size(), 2u);
  EXPECT_EQ(folders.front(), "mine");
  EXPECT_TRUE(std::filesystem::exists(folders.back() / "twines.toml"));
}

}  // namespace
}  // namespace netloft::gears
