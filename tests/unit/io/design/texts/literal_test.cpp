// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/texts/literal.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace netloft::design {
namespace {

TEST(Literal, EndsWhereTheValueEnds) {
  const std::vector<std::string> literals{"-2.5e3",
                                          "1_000",
                                          "true",
                                          "\"a # b\"",
                                          R"("a\"b")",
                                          "'a\\'",
                                          "[1, \"]\", 2]",
                                          "{ a = [1], b = '}' }",
                                          "\"\"\"a\nb\"\"\"",
                                          "'''x'y'''",
                                          "[ 1, # ]\n 2 ]",
                                          "\"\"\"a\"\"\"\"",
                                          "\"\"",
                                          "1979-05-27"};
  for (const std::string& literal : literals)
    for (const std::string rest : {"", " # comment", "\n", ", 3]", "}"}) {
      EXPECT_EQ(length_of_literal("x = " + literal + rest, 4), literal.size()) << literal << rest;
    }
}

TEST(Literal, IsFoundAtItsLineAndColumnInCharacters) {
  const std::string text = "ä = 1\r\nüü = 22\n\n";
  EXPECT_EQ(text[byte_at(text, 1, 5)], '1');
  EXPECT_EQ(text.substr(byte_at(text, 2, 6), 2), "22");
  EXPECT_EQ(text[byte_at(text, 2, 100)], '\n');
  EXPECT_EQ(byte_at(text, 100, 1), text.size());
}

}  // namespace
}  // namespace netloft::design
