// SPDX-License-Identifier: BSD-3-Clause
#include "framework/parameters/nearest.hpp"

#include <gtest/gtest.h>

namespace netloft {
namespace {

const std::vector<std::string> kKeys = {"diameter", "density", "EA", "EA_compression"};

TEST(Nearest, FindsTwoLettersInTheWrongOrder) { EXPECT_EQ(nearest("diametre", kKeys), "diameter"); }
TEST(Nearest, FindsAMissingLetter) { EXPECT_EQ(nearest("densty", kKeys), "density"); }
TEST(Nearest, IgnoresLetterCase) { EXPECT_EQ(nearest("ea", kKeys), "EA"); }
TEST(Nearest, FindsNothingForAStranger) { EXPECT_EQ(nearest("colour", kKeys), std::nullopt); }
TEST(Nearest, FindsNothingForNoWord) { EXPECT_EQ(nearest("", kKeys), std::nullopt); }
TEST(Nearest, FindsNothingAmongNone) { EXPECT_EQ(nearest("EA", {}), std::nullopt); }
TEST(Nearest, DoesNotReplaceTheOnlyLetter) {
  const std::vector<std::string> keys = {"b"};
  EXPECT_EQ(nearest("a", keys), std::nullopt);
}
TEST(Nearest, TakesTheNearerOfTwo) {
  const std::vector<std::string> keys = {"twines", "twine"};
  EXPECT_EQ(nearest("twinne", keys), "twine");
}
TEST(Nearest, CountsAnExchangeOfNeighboursAsOneSlip) { EXPECT_EQ(detail::edit_distance("ab", "ba"), 1u); }
TEST(Nearest, CountsTheClassicSlips) { EXPECT_EQ(detail::edit_distance("kitten", "sitting"), 3u); }
TEST(Nearest, GivesUpOnAnEndlessWord) {
  const std::vector<std::string> keys = {std::string(1000, 'a')};
  EXPECT_EQ(nearest(std::string(1000, 'a'), keys), std::nullopt);
}

}  // namespace
}  // namespace netloft
