// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/line_changes.hpp"

#include <gtest/gtest.h>

namespace netloft::results {
namespace {

/// The changes as a text such as "-2 b, +2 x".
std::string changes(const std::string& before, const std::string& after) {
  std::string text;
  for (const auto& change : find_line_changes(before, after))
    text += (text.empty() ? "" : ", ") + std::string(change.is_new ? "+" : "-") +
            std::to_string(change.line) + " " + change.text;
  return text;
}

TEST(LineChanges, AreNoneOfEqualTexts) {
  EXPECT_EQ(changes("a\nb\n", "a\nb\n"), "");
  EXPECT_EQ(changes("", ""), "");
  EXPECT_EQ(changes("a", "a\n"), "");
}

TEST(LineChanges, AreTheFewestThereAre) {
  EXPECT_EQ(changes("a\nb\nc\n", "a\nx\nc\n"), "-2 b, +2 x");
  EXPECT_EQ(changes("a\nb\nc\nd\n", "b\nc\ne\nd\n"), "-1 a, +3 e");
  EXPECT_EQ(changes("a\na\nb\n", "a\nb\n"), "-2 a");
}

TEST(LineChanges, ReachBothEnds) {
  EXPECT_EQ(changes("", "a\nb\n"), "+1 a, +2 b");
  EXPECT_EQ(changes("a\nb\n", ""), "-1 a, -2 b");
}

TEST(LineChanges, OfVeryLongTextsStillTellAllThatDiffers) {
  std::string before, after;
  for (int i = 0; i < 3000; ++i)
    before += "a" + std::to_string(i) + "\n", after += "b" + std::to_string(i) + "\n";
  EXPECT_EQ(find_line_changes("same\n" + before, "same\n" + after).size(), 6000u);
}

}  // namespace
}  // namespace netloft::results
