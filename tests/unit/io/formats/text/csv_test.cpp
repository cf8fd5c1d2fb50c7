// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/csv.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace netloft::formats {
namespace {

TEST(CsvField, QuotesWhatSeparatesCells) {
  EXPECT_EQ(csv_field("plain"), "plain");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a\"b"), "\"a\"\"b\"");
  EXPECT_EQ(csv_field("a\r\nb"), "\"a\nb\"");
}

TEST(CsvField, IsNoFormula) {
  EXPECT_EQ(csv_field("=HYPERLINK(\"x\")"), "\"'=HYPERLINK(\"\"x\"\")\"");
  for (const std::string text : {"@SUM(A1)", "+1+2", "-2+3", "-3 m", "=1", "\t=1"})
    EXPECT_EQ(csv_field(text), "'" + text);
  for (const char* number : {"-5", "+3e2", "-0.25"}) EXPECT_EQ(csv_field(number), number);
  EXPECT_EQ(csv_field("a=1"), "a=1");
  EXPECT_EQ(csv_field(""), "");
}

TEST(CsvField, HoldsNoControlCharacters) { EXPECT_EQ(csv_field("\x1b]0;x\x07"), "\\u001b]0;x\\u0007"); }

TEST(CsvNumber, IsEmptyIfItIsNotKnown) {
  EXPECT_EQ(csv_number(-0.5), "-0.5");
  EXPECT_EQ(csv_number(std::numeric_limits<double>::quiet_NaN()), "");
}

}  // namespace
}  // namespace netloft::formats
