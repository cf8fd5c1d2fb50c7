// SPDX-License-Identifier: BSD-3-Clause
#include "io/stability/references.hpp"

#include "tests/unit/io/toml/scratch.hpp"

namespace netloft::io {
namespace {

class Book : public testing::Scratch {};

TEST_F(Book, KeepsEveryBitOfAnAnswer) {
  const auto file = folder_ / "references.json";
  const Reference kept{816, -58006.493614954, 0.1 + 0.2, 763, 1e-17, {{5, {1.0 / 3, -2e-300, 7}}}, "newton"};
  References book(file);
  EXPECT_FALSE(book.find("panel", "small"));
  book.keep("panel", "small", kept);
  book.save();
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

TEST_F(Book, SaysWhichFileCannotBeRead) {
  const auto file = write("references.json", "{ \"panel\": 3 }");
  try {
    References book(file);
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("references.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace netloft::io
