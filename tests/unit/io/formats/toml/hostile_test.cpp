// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "io/formats/toml/key_depth.hpp"
#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::formats {
namespace {

using test::Input;

std::string repeated(const std::string& text, int n) {
  std::string result;
  for (int i = 0; i < n; ++i) result += text;
  return result;
}

TEST(Hostile, DeepArraysAreRefused) {
  EXPECT_EQ(Input("a = " + repeated("[", 100) + repeated("]", 100)).error(),
            "1:69: nested deeper than 64 levels");
}
TEST(Hostile, BottomlessArraysAreRefused) { EXPECT_NE(Input("a = " + repeated("[", 1000000)).error(), ""); }
TEST(Hostile, BottomlessTablesAreRefused) { EXPECT_NE(Input("a = " + repeated("{a=", 1000000)).error(), ""); }
TEST(Hostile, BottomlessDottedKeysAreRefused) {
  EXPECT_EQ(Input("x = 1\n" + repeated("a.", 200000) + "b = 1").error(),
            "2:64: a dotted key has more than 32 parts");
}
TEST(Hostile, BottomlessHeadersAreRefused) {
  EXPECT_EQ(Input("[" + repeated("a . ", 200000) + "b]").error(),
            "1:128: a dotted key has more than 32 parts");
}
TEST(Hostile, DottedKeysThroughNestedTablesAreRefused) {
  EXPECT_NE(
      Input("x = " + repeated("{" + repeated("a.", 31) + "b = ", 250) + "1" + repeated("}", 250)).error(),
      "");
}
TEST(Hostile, ThirtyTwoPartsArePassed) { EXPECT_EQ(Input(repeated("a.", 31) + "b = 1").error(), ""); }
TEST(Hostile, DotsInTextsAndCommentsAreNoKeys) {
  const std::string dots = repeated(".", 100);
  EXPECT_FALSE(find_deep_key("a = \"" + dots + "\"\nb = '" + dots + "'\nc = \"\"\"" + dots +
                             "\"\"\"\nd = '''" + dots + "''' # " + dots));
}
TEST(Hostile, DotsBehindAnEscapedQuoteAreNoKeys) {
  EXPECT_FALSE(find_deep_key("a = \"\\\"" + repeated(".", 100) + "\""));
}
TEST(Hostile, LongColumnsOfDecimalsArePassed) {
  Input in("a = [" + repeated("1.5, ", 200000) + "]");
  EXPECT_EQ(in.reader.reals("a", {}).size(), 200000u);
}
TEST(Hostile, LongTextsArePassed) {
  Input in("a = \"" + repeated("x", 1000000) + "\"");
  EXPECT_EQ(in.reader.text("a", {}).size(), 1000000u);
}
TEST(Hostile, LongTextsAreShownShort) {
  Input in("a = \"" + repeated("é", 1000000) + "\"");
  in.reader.integer("a", {});
  EXPECT_LT(in.diagnostics.render(false).size(), 1000u);
}
TEST(Hostile, AFloodOfUnknownKeysIsCutOff) {
  std::string text;
  for (int i = 0; i < 10000; ++i) text += "k" + std::to_string(i) + " = 1\n";
  Input in(text);
  in.reader.finish();
  EXPECT_EQ(in.diagnostics.errors(), 50);
}
TEST(Hostile, AFloodOfBadItemsIsCutOff) {
  Input in("a = [" + repeated("true, ", 10000) + "]");
  in.reader.reals("a", {});
  EXPECT_EQ(in.diagnostics.errors(), 5);
}
TEST(Hostile, ManyHeadersTakeNoMoreThanTheirTime) {
  Input in(repeated("[[hold]]\n", 20000));
  EXPECT_EQ(in.reader.tables("hold").size(), 20000u);
}

TEST(Hostile, RandomSlipsAreSurvived) {
  const std::string good =
      "include = []\n[parts.net]\ntype = \"a/b\"\nsketch = [[-16, 0, 0.5], [\"1 m\", nan, inf]]\n"
      "twine = { EA = \"10 kN\", \"x y\".z = 1e9 }\n[[hold]]\non = '''a'''\nwhen = 2020-01-01T00:00:00Z\n";
  const std::string signs = "[]{}=.\"'#\\\n ,-+eE0x_\xc3\xa9";
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    std::string text = good;
    for (int slips = 0; slips < 4; ++slips) {
      const std::size_t at = random() % text.size();
      if (random() % 2)
        text.erase(at, 1 + random() % 4);
      else
        text.insert(at, 1, signs[random() % signs.size()]);
    }
    Input in(text, {text.substr(0, random() % text.size())});
    in.reader.table("parts").table("net").rows("sketch", {.unit = "m"});
    in.reader.finish();
    in.diagnostics.render(true);
  }
}

}  // namespace
}  // namespace netloft::formats
