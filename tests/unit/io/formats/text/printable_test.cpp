// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/printable.hpp"

#include <gtest/gtest.h>

namespace netloft::formats {
namespace {

TEST(Printable, EscapesBothSetsOfControlCharacters) {
  EXPECT_EQ(printable("\x1b[31mred\x07"), "\\u001b[31mred\\u0007");
  EXPECT_EQ(printable("\x7f"), "\\u007f");
  EXPECT_EQ(printable("\xc2\x80 \xc2\x9b 31m \xc2\x9f"), "\\u0080 \\u009b 31m \\u009f");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\u0000b");
  EXPECT_EQ(printable("a\rb\r\n"), "a\\u000db\n");
}

TEST(Printable, EscapesBytesThatATerminalWithoutUtf8Obeys) {
  EXPECT_EQ(printable("\x9b\x33\x31m"), "\\u009b31m");
  EXPECT_EQ(printable("caf\xe9"), "caf\xe9");
  EXPECT_EQ(printable("\xc2"), "\xc2");
}

TEST(Printable, LeavesTextAsItIs) {
  const std::string text = "Größe 3 m²\n\t± 0.5 \xc2\xa0 日本 \xf0\x9f\x90\x9f";
  EXPECT_EQ(printable(text), text);
  EXPECT_FALSE(has_control_characters("Größe \xf0\x9f\x90\x9f"));
}

TEST(Printable, KeepsNoLineEndWithinALine) {
  EXPECT_EQ(printable_in_line("a\n\tb"), "a\\u000a b");
  for (const char* text : {"a\n", "a\t", "\x1b", "\xc2\x85", "\x85"})
    EXPECT_TRUE(has_control_characters(text));
}

}  // namespace
}  // namespace netloft::formats
