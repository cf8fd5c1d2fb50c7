// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/mesh/text_rows.hpp"

#include <gtest/gtest.h>

namespace netloft::formats {
namespace {

TEST(Number, IsReadAsProgramsWriteIt) {
  EXPECT_EQ(number_in("1"), 1);
  EXPECT_EQ(number_in("-1.5"), -1.5);
  EXPECT_EQ(number_in("+.5"), 0.5);
  EXPECT_EQ(number_in("3."), 3);
  EXPECT_EQ(number_in("1e-05"), 1e-5);
  EXPECT_EQ(number_in("1.D-3"), 1e-3);
  EXPECT_EQ(number_in("1e-999"), 0);
}

TEST(Number, IsNoWordAndNotInfinite) {
  for (const char* text : {"", "-", "+", "e5", "nan", "inf", "0x10", "1,5", "1e999", "--1", "+-1", "1 "})
    EXPECT_FALSE(number_in(text)) << text;
  EXPECT_FALSE(number_in(std::string(100, '1')));
}

TEST(Integer, HasNoPoint) {
  EXPECT_EQ(integer_in("-12"), -12);
  EXPECT_EQ(integer_in("+7"), 7);
  for (const char* text : {"", "1.", "1e3", "x", "99999999999999999999"})
    EXPECT_FALSE(integer_in(text)) << text;
}

TEST(TextRows, EndWithAnyLineEnd) {
  TextRows rows("a b\r\n\r\nc\rd\n", 0);
  EXPECT_EQ(rows.next_row().size(), 2u);
  const auto c = rows.next_row();
  ASSERT_EQ(c.size(), 1u);
  EXPECT_EQ(c[0].text, "c");
  EXPECT_EQ(c[0].place.line, 3);
  EXPECT_EQ(rows.next_row()[0].place.line, 4);
  EXPECT_TRUE(rows.next_row().empty());
}

TEST(TextRows, CountColumnsInCharacters) {
  TextRows rows("\xC3\xA9 1 # 2", 0, '#');
  const auto row = rows.next_row();
  ASSERT_EQ(row.size(), 2u);
  EXPECT_EQ(row[1].place.column, 3);
}

}  // namespace
}  // namespace netloft::formats
