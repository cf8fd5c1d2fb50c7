// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/references.hpp"

#include "tests/folders.hpp"
#include "tests/unit/io/formats/toml/scratch.hpp"

#include <cmath>

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;
using namespace runs;

namespace {

class Book : public formats::test::Scratch {};

TEST_F(Book, KeepsEveryBitOfAnAnswer) {
  const auto file = folder_ / "references.json";
  const Reference kept{816, -58006.493614954, 0.1 + 0.2, 763, 1e-17, {{5, {1.0 / 3, -2e-300, 7}}}, "newton"};
  References answers(file);
  EXPECT_FALSE(answers.find("panel", "small"));
  answers.keep("panel", "small", kept);
  answers.save();
  const auto read = References(file).find("panel", "small");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->unknowns, kept.unknowns);
  EXPECT_EQ(read->energy, kept.energy);
  EXPECT_EQ(read->size, kept.size);
  EXPECT_EQ(read->load, kept.load);
  EXPECT_EQ(read->noise, kept.noise);
  EXPECT_EQ(read->found_by, kept.found_by);
  ASSERT_EQ(read->nodes.size(), 1u);
  EXPECT_EQ(read->nodes[0].node, 5u);
  EXPECT_EQ(read->nodes[0].x, kept.nodes[0].x);
}

TEST_F(Book, ForgetsAnAnswerOfOneSize) {
  References answers(folder_ / "references.json");
  for (const char* size : {"small", "medium"}) answers.keep("panel", size, {});
  answers.forget("panel", "medium");
  answers.forget("rope", "small");
  EXPECT_TRUE(answers.find("panel", "small"));
  EXPECT_FALSE(answers.find("panel", "medium"));
}

TEST_F(Book, SaysWhichFileCannotBeRead) {
  const auto file = write("references.json", "{ \"panel\": 3 }");
  try {
    References answers(file);
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("references.json"), std::string::npos);
  }
}

// Energies of the two panels of the paper, from an independent program (residuals in 80 bits, to 1e-13 N), on
// the same meshes. The tests of these panels in tests/verification take positions from the same program.
TEST(TheBook, AgreesWithAnIndependentProgramAboutThePanelsOfThePaper) {
  const References answers(netloft::test::source_folder() + "/tests/stability/references.json");
  const auto expect = [&](const std::string& name, const std::string& size, double energy) {
    const auto known = answers.find(name, size);
    ASSERT_TRUE(known) << name;
    EXPECT_NEAR(known->energy, energy, 1e-12 * std::abs(energy)) << name << " " << size;
  };
  expect("hanging-panel", "small", -57847.2684276217);
  expect("hanging-panel", "medium", -58006.4936149543);
  expect("hanging-panel", "large", -58158.9429421238);
  expect("hanging-panel-tension-only", "small", -57847.2954859953);
  expect("hanging-panel-tension-only", "medium", -58006.5172329208);
  expect("hanging-panel-tension-only", "large", -58158.9429967772);
  expect("stretched-panel", "small", 6.27391948524973);
  expect("stretched-panel", "medium", 5.988740341919);
  expect("stretched-panel", "large", 5.79603974530409);
}

}  // namespace
}  // namespace netloft::hard_cases
