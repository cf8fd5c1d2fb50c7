// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/record.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

#include <cmath>
#include <limits>

namespace netloft::studies {
namespace {

StudyItem two_points() {
  StudyItem item;
  item.hash = "fnv1a64:0123456789abcdef", item.points.resize(2);
  return item;
}

ItemRecord sample() {
  PointRecord good{"converged",
                   "locally unstable",
                   "so small",
                   "continued",
                   {"a jump"},
                   3,
                   4,
                   4.25,
                   {{"gear/x", "m", 0.1}, {"gear/y", "N", 1e-300}}};
  PointRecord bad{"not converged",
                  "unknown",
                  "line\nbreak \"quote\"",
                  "anew",
                  {},
                  9,
                  9,
                  9,
                  {{"gear/x", "m", std::numeric_limits<double>::quiet_NaN()}}};
  return {two_points().hash, "1.0", {good, bad}, {1.5, 1.25, "host", "now"}};
}

std::string refusal(const std::string& text, const StudyItem& item = two_points()) {
  try {
    read_record(text, item);
    return "";
  } catch (const StudyError& e) {
    return e.what();
  }
}

TEST(ItemRecord, IsReadBackToTheBit) {
  const std::string text = record_text(sample());
  const ItemRecord read = read_record(text, two_points());
  EXPECT_EQ(record_text(read), text);
  EXPECT_EQ(read.points[0].figures[0].value, 0.1);
  EXPECT_EQ(read.points[0].figures[1].value, 1e-300);
  EXPECT_TRUE(read.points[1].figures.empty()) << "NaN is no figure";
  EXPECT_EQ(read.points[1].reason, sample().points[1].reason);
  EXPECT_EQ(read.points[0].stability, "locally unstable");
}
TEST(ItemRecord, IsRefusedWhereAnyByteIsDamaged) {
  const std::string text = record_text(sample());
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string changed = text;
    changed[at] = static_cast<char>(changed[at] ^ 0x04);
    EXPECT_NE(refusal(changed), "") << at;
  }
  for (std::size_t length = 0; length < text.size(); ++length) EXPECT_NE(refusal(text.substr(0, length)), "");
}
TEST(ItemRecord, IsRefusedIfAFigureIsNoPathOrHoldsControlCharacters) {
  for (const char* name : {"", "/", "/gear/x", "gear/", "gear//x", "gear/\x1b[31mx", "gear/x\ny"}) {
    ItemRecord record = sample();
    record.points[0].figures[0].name = name;
    EXPECT_NE(refusal(record_text(record)).find("a figure cannot be called"), std::string::npos) << name;
  }
  ItemRecord record = sample();
  record.points[0].figures[0].unit = std::string("m\0", 2);
  EXPECT_NE(refusal(record_text(record)), "");
}
TEST(ItemRecord, IsRefusedForAnotherItem) {
  StudyItem other = two_points();
  other.hash = "fnv1a64:0000000000000000";
  EXPECT_EQ(refusal(record_text(sample()), other), "it is the record of another item");
  other = two_points(), other.points.resize(3);
  EXPECT_EQ(refusal(record_text(sample()), other), "it is the record of another item");
}

class FoundRecord : public formats::test::Scratch {};
TEST_F(FoundRecord, IsNoneWhereThereIsNoFileOrADamagedOne) {
  const StudyItem item = two_points();
  std::string fault;
  EXPECT_FALSE(find_record(folder_, item, fault));
  EXPECT_EQ(fault, "");
  write("items/0123456789abcdef.json", "garbage");
  EXPECT_FALSE(find_record(folder_, item, fault));
  EXPECT_NE(fault.find("0123456789abcdef.json: it is damaged"), std::string::npos);
  write("items/0123456789abcdef.json", record_text(sample()));
  EXPECT_TRUE(find_record(folder_, item, fault));
}

}  // namespace
}  // namespace netloft::studies
