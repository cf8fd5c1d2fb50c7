// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/similar_names.hpp"

#include "io/gears/catalogue/folders.hpp"
#include "tests/unit/io/gears/catalogue/folder.hpp"

#include <gtest/gtest.h>

namespace netloft::gears {
namespace {

const Catalogue& library_parts() {
  static const Catalogue parts = [] {
    formats::Diagnostics diagnostics;
    return Catalogue::load(catalogue_folders(diagnostics), diagnostics);
  }();
  return parts;
}

/// Names of the library's parts that are similar to a name, joined by spaces.
std::string similar(const std::string& name, const std::string& kind) {
  std::vector<const CataloguePart*> parts;
  for (const auto& part : library_parts().parts())
    if (part.kind->name == kind) parts.push_back(&part);
  std::string text;
  for (const auto& near : similar_names(name, parts, library_parts().synonyms()))
    text += (text.empty() ? "" : " ") + near;
  return text;
}

TEST(SimilarNames, AMisspeltNameIsCorrected) {
  EXPECT_EQ(similar("pe-braided-4m", "twine"), "pe-braided-4mm");
  EXPECT_EQ(similar("hpme-12mm", "rope"), "hmpe-12mm");
}

TEST(SimilarNames, AnotherWordForTheMaterialIsUnderstood) {
  EXPECT_EQ(similar("dyneema-12mm", "rope"), "hmpe-12mm");
  EXPECT_EQ(similar("Polyamide-16mm", "rope"), "nylon-16mm");
  EXPECT_EQ(similar("polypropylene-3-strand-18mm", "rope"), "pp-3-strand-18mm");
  EXPECT_EQ(similar("spectra-braided-3mm", "twine"), "hmpe-braided-3mm");
}

TEST(SimilarNames, TheNearestDiametersComeFirst) {
  EXPECT_EQ(similar("nylon-2mm", "twine"), "pa-twisted-2mm");
  EXPECT_EQ(similar("nylon-2.1mm", "twine"), "pa-twisted-2mm pa-twisted-2.3mm pa-twisted-1.5mm");
  EXPECT_EQ(similar("polyethylene-3mm", "twine"), "pe-braided-3mm pe-twisted-3mm");
  EXPECT_EQ(similar("PES-22mm", "rope"), "polyester-20mm polyester-24mm polyester-16mm");
}

TEST(SimilarNames, AMaterialAloneIsAnswered) {
  EXPECT_EQ(similar("dyneema", "twine"), "hmpe-braided-2mm hmpe-braided-3mm hmpe-braided-4mm");
}

TEST(SimilarNames, NothingIsProposedForAnotherMaterial) {
  EXPECT_EQ(similar("polysteel-20mm", "rope"), "");
  EXPECT_EQ(similar("", "rope"), "");
  EXPECT_EQ(similar(std::string(1000, 'a'), "rope"), "");
}

TEST(SimilarNames, SynonymsAreGroupsOfWords) {
  TestFolder folder;
  for (const char* wrong : {"synonyms = 3\n", "synonyms = [\"pa\"]\n", "synonyms = [[1]]\n"}) {
    folder.write("own.toml", wrong);
    formats::Diagnostics diagnostics;
    Catalogue::load({folder.path()}, diagnostics);
    EXPECT_EQ(diagnostics.errors(), 1) << diagnostics.render(false);
  }
}

}  // namespace
}  // namespace netloft::gears
