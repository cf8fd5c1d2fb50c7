// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/spelled_value.hpp"

#include "io/formats/toml/change.hpp"
#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::formats {
namespace {

using test::Input;

/// Writes a value as TOML and checks that --set reads the same value from this text.
std::string spelt(const std::string& toml) {
  Input in("v = " + toml);
  const Value& value = in.document.root().as<Table>()->find("v")->value;
  const std::string text = spell_value(value);
  Value again{{}, Table{}};
  Diagnostics diagnostics;
  apply(again, read_change("v=" + text), diagnostics);
  const Value& back = again.as<Table>()->find("v")->value;
  EXPECT_EQ(back.kind(), value.kind()) << text;
  EXPECT_EQ(spell_value(back), text);
  return text;
}

TEST(SpelledValue, LeavesQuantitiesAndNamesWithoutQuotes) {
  EXPECT_EQ(spelt("\"2.5 kn\""), "2.5 kn");
  EXPECT_EQ(spelt("\"pe-braided-4mm\""), "pe-braided-4mm");
  EXPECT_EQ(spelt("\"priour/triangle\""), "priour/triangle");
}
TEST(SpelledValue, QuotesTextsThatWouldBeReadAsSomethingElse) {
  EXPECT_EQ(spelt("\"3\""), "\"3\"");
  EXPECT_EQ(spelt("\"true\""), "\"true\"");
  EXPECT_EQ(spelt("\"1e3\""), "\"1e3\"");
  EXPECT_EQ(spelt("\"83-112\""), "\"83-112\"");
  EXPECT_EQ(spelt("\"1979-05-27\""), "\"1979-05-27\"");
  EXPECT_EQ(spelt("\"[1, 2]\""), "\"[1, 2]\"");
  EXPECT_EQ(spelt("\"\""), "\"\"");
  EXPECT_EQ(spelt("\"a \\\"b\\\" \\\\ \\u0001\""), "\"a \\\"b\\\" \\\\ \\u0001\"");
}
TEST(SpelledValue, KeepsKindsOfNumbers) {
  EXPECT_EQ(spelt("64"), "64");
  EXPECT_EQ(spelt("64.0"), "64.0");
  EXPECT_EQ(spelt("0.1"), "0.1");
  EXPECT_EQ(spelt("1e300"), "1e300");
  EXPECT_EQ(spelt("false"), "false");
}
TEST(SpelledValue, KeepsQuotesInsideArraysAndTables) {
  EXPECT_EQ(spelt("[\"1 m\", 2, [3]]"), "[\"1 m\", 2, [3]]");
  EXPECT_EQ(spelt("{ part = \"pe-braided-4mm\", \"a b\" = 1 }"), "{part = \"pe-braided-4mm\", \"a b\" = 1}");
}

}  // namespace
}  // namespace netloft::formats
