// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/cutting.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace netloft::gears {
namespace {

struct Rate {
  const char* written;
  double across, deep;  // of a cycle, in meshes
};

class CuttingRates : public testing::TestWithParam<Rate> {};

/// A bar goes half a mesh across and half a mesh deep, a point one deep, a mesh one across.
TEST_P(CuttingRates, CountTheirCycle) {
  const auto rate = parse_rate(GetParam().written);
  ASSERT_TRUE(rate);
  EXPECT_DOUBLE_EQ(0.5 * rate->half_meshes_across(), GetParam().across);
  EXPECT_DOUBLE_EQ(0.5 * rate->half_meshes_deep(), GetParam().deep);
}

INSTANTIATE_TEST_SUITE_P(OfTheTrade, CuttingRates,
                         testing::Values(Rate{"5B1P", 2.5, 3.5}, Rate{"5B1M", 3.5, 2.5},
                                         Rate{"3B1M", 2.5, 1.5}, Rate{"AB", 0.5, 0.5}, Rate{"AN", 0, 1},
                                         Rate{"AP", 0, 1}, Rate{"AM", 1, 0}, Rate{"AT", 1, 0},
                                         Rate{"1N2B", 1, 2}, Rate{"1P4B", 2, 3}, Rate{"1T2B", 2, 1},
                                         Rate{"12B1N", 6, 7}));

TEST(CuttingRate, IsTheSameWithPointsOrNAndMeshesOrT) {
  EXPECT_EQ(*parse_rate("5B1P"), *parse_rate("1N5B"));
  EXPECT_EQ(*parse_rate("3B1M"), *parse_rate("1T3B"));
}

TEST(CuttingRate, WhatIsNoRateIsNone) {
  for (const char* text : {"", "A", "B", "381M", "5B", "1P", "5B1", "B1P", "0B1P", "5B1B", "1P1M", "5B1P1M",
                           "5b1p", "AX", "5B 1P", "ABN", "1000B1P", "99999999999999999999B1P", "-5B1P"})
    EXPECT_FALSE(parse_rate(text)) << text;
}

/// Cutting at 5B1P over a depth of 70 meshes takes 20 cycles, each 3.5 meshes deep and 2.5 meshes across.
TEST(CuttingRate, AddsUpWholeCyclesExactly) {
  EXPECT_EQ(parse_rate("5B1P")->across(70), 50);
  EXPECT_EQ(parse_rate("5B1P")->deep(50), 70);
}

TEST(CuttingRate, ABlurredLetterHidesFewRates) {
  const auto near = rates_near("381M");
  EXPECT_EQ(near, std::vector<std::string>{"3B1M"});
}

}  // namespace
}  // namespace netloft::gears
