// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/likely_path.hpp"

#include <gtest/gtest.h>

namespace netloft::formats {
namespace {

const std::vector<std::string> kFigures = {"mouth/area", "mouth/headline_height", "tow.speed"};

TEST(LikelyPath, IsTheNearest) { EXPECT_EQ(likely_path("mouth/aera", kFigures), "mouth/area"); }
TEST(LikelyPath, MayHaveLostItsBeginning) {
  EXPECT_EQ(likely_path("headline_height", kFigures), "mouth/headline_height");
  EXPECT_EQ(likely_path("speed", kFigures), "tow.speed");
}
TEST(LikelyPath, EndsWithWholeNames) { EXPECT_EQ(likely_path("height", kFigures), std::nullopt); }
TEST(LikelyPath, IsNoneForNothing) { EXPECT_EQ(likely_path("", kFigures), std::nullopt); }

}  // namespace
}  // namespace netloft::formats
