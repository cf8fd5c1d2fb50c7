// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/diagnostics.hpp"

#include <gtest/gtest.h>

namespace netloft::formats {
namespace {

std::vector<std::string> messages(const Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const Diagnostic& entry : diagnostics.sorted()) result.push_back(entry.message);
  return result;
}

TEST(Diagnostics, SortBySourceThenLineThenColumn) {
  Diagnostics diagnostics;
  const int root = diagnostics.add_source("z.toml", "");
  const int included = diagnostics.add_source("a.toml", "");
  diagnostics.error({included, 1, 1}, "fourth");
  diagnostics.error({root, 2, 1}, "third");
  diagnostics.error({root, 1, 9}, "second");
  diagnostics.error({root, 1, 2}, "first");
  EXPECT_EQ(messages(diagnostics), (std::vector<std::string>{"first", "second", "third", "fourth"}));
}

TEST(Diagnostics, TellEachThingOnce) {
  Diagnostics diagnostics;
  const int file = diagnostics.add_source("a.toml", "");
  diagnostics.error({file, 1, 1}, "same");
  diagnostics.error({file, 1, 1}, "same");
  EXPECT_EQ(diagnostics.errors(), 1);
}

TEST(Diagnostics, DoNotCountWarningsAsErrors) {
  Diagnostics diagnostics;
  diagnostics.warning({}, "careful");
  EXPECT_EQ(diagnostics.errors(), 0);
  EXPECT_EQ(diagnostics.warnings(), 1);
}

TEST(Diagnostics, RenderPlaceLineUnderlineAndHint) {
  Diagnostics diagnostics;
  const int file = diagnostics.add_source("codend.toml", "[twine]\nEA = \"-5 N\"\n");
  diagnostics.error({file, 2, 6, 6}, "twine.EA is negative", "ropes do not push");
  EXPECT_EQ(diagnostics.render(false),
            "codend.toml:2:6: error: twine.EA is negative\n"
            "  2 | EA = \"-5 N\"\n"
            "    |      ^~~~~~\n"
            "  hint: ropes do not push\n");
}

TEST(Diagnostics, CountColumnsInCharacters) {
  Diagnostics diagnostics;
  const int file = diagnostics.add_source("a.toml", "\"é\" = 5");
  diagnostics.error({file, 1, 7}, "no");
  EXPECT_EQ(diagnostics.render(false),
            "a.toml:1:7: error: no\n"
            "  1 | \"é\" = 5\n"
            "    |       ^\n");
}

TEST(Diagnostics, ShowTheNeighbourhoodOfASpotInALongLine) {
  Diagnostics diagnostics;
  const int file = diagnostics.add_source("a.toml", std::string(5000, 'x') + "Y" + std::string(5000, 'x'));
  diagnostics.error({file, 1, 5001, 1}, "no");
  const std::string text = diagnostics.render(false);
  EXPECT_LT(text.size(), 350u);
  std::vector<std::string> lines;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  EXPECT_EQ(lines.at(1).find('Y'), lines.at(2).find('^'));
}

TEST(Diagnostics, SurviveASpotBeyondTheLine) {
  Diagnostics diagnostics;
  const int file = diagnostics.add_source("a.toml", "a =");
  diagnostics.error({file, 1, 900, 900}, "no");
  diagnostics.error({file, 900, 1}, "no");
  EXPECT_NE(diagnostics.render(false).find("a.toml:900:1: error: no\n"), std::string::npos);
}

TEST(Diagnostics, ShowTheCommandLineByItsName) {
  Diagnostics diagnostics;
  const int source = diagnostics.add_source("--set a.b", "a.b=3", Diagnostics::Source::command_line);
  diagnostics.error({source, 1, 5, 1}, "no");
  EXPECT_EQ(diagnostics.render(false), "--set a.b: error: no\n  1 | a.b=3\n    |     ^\n");
}

TEST(Diagnostics, AreColoredOnlyWhenAsked) {
  Diagnostics diagnostics;
  diagnostics.error({}, "no");
  EXPECT_EQ(diagnostics.render(false), "error: no\n");
  EXPECT_EQ(diagnostics.render(true), "\033[1;31merror:\033[0m no\n");
}

TEST(Diagnostics, PassNoControlCharactersOn) {
  Diagnostics diagnostics;
  const int file = diagnostics.add_source("a\033.toml", "a =\t\033[2J\u009b1 # ok");
  diagnostics.error({file, 1, 5, 4}, "saw \033[2J\nall is well", "no \a");
  EXPECT_EQ(diagnostics.render(false),
            "a\\u001b.toml:1:5: error: saw \\u001b[2J\\u000aall is well\n"
            "  1 | a = \\u001b[2J\\u009b1 # ok\n"
            "    |     ^~~~~~~~~\n"
            "  hint: no \\u0007\n");
}

TEST(Diagnostics, SayHowManyWereLeftOut) {
  Diagnostics diagnostics;
  for (int i = 0; i < 5; ++i) diagnostics.error({}, std::to_string(i));
  EXPECT_EQ(diagnostics.render(false, 2), "error: 0\nerror: 1\n… and 3 more\n");
}

}  // namespace
}  // namespace netloft::formats
