// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/in_quotes.hpp"

#include <gtest/gtest.h>

namespace netloft::formats {
namespace {

TEST(InQuotes, ShowsAShortTextWhole) { EXPECT_EQ(in_quotes("a"), "\"a\""); }

TEST(InQuotes, CutsALongTextBetweenCharacters) {
  const std::string a(58, 'a');
  EXPECT_EQ(in_quotes(a + "äö" + a), "\"" + a + "ä...\"");
  EXPECT_EQ(in_quotes(a + "aäö" + a), "\"" + a + "a...\"");
}

/// The text consists of bytes that only continue a UTF-8 character, so that no cut is between characters.
TEST(InQuotes, CutsWhatIsNoTextSomewhere) { EXPECT_EQ(in_quotes(std::string(80, '\xA3')).size(), 57 + 5u); }

}  // namespace
}  // namespace netloft::formats
