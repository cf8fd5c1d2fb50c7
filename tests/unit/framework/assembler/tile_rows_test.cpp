// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/tile_rows.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace netloft {
namespace {

constexpr std::size_t kWidth = NETLOFT_LANES;

TEST(TileRows, AreZeroWheneverATileBegins) {
  TileRows rows(4);
  rows.clear();
  rows.open(4, 5)[3 * kWidth + 4] = 1;
  rows.clear();
  rows.open(2, kWidth);
  for (std::size_t i = 0; i < 4 * kWidth; ++i) EXPECT_EQ(rows.data()[i], 0) << i;
}

TEST(TileRows, TellWhetherATileHasAddedSomething) {
  TileRows rows(3);
  rows.clear();
  rows.open(3, 7);
  EXPECT_TRUE(rows.is_zero());
  rows.clear();
  rows.open(3, 7)[2 * kWidth + 6] = -1e-300;
  EXPECT_FALSE(rows.is_zero());
}

TEST(TileRows, TakeMinusZeroForZeroAndNotANumberForSomething) {
  TileRows rows(1);
  rows.clear();
  rows.open(1, 2)[0] = -0.0;
  EXPECT_TRUE(rows.is_zero());
  rows.clear();
  rows.open(1, 2)[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(rows.is_zero());
}

TEST(TileRows, BeginCleanAfterATileThatAddedNothing) {
  TileRows rows(2);
  rows.clear();
  rows.open(2, 3);
  EXPECT_TRUE(rows.is_zero());
  rows.clear();
  rows.open(1, 1)[0] = 5;
  rows.clear();
  rows.open(2, 3);
  EXPECT_TRUE(rows.is_zero());
}

// A plugin must not; its mistake stays with the tile that it made it in.
TEST(TileRows, ForgetWhatWasWrittenBeyondTheLastLane) {
  TileRows rows(2);
  rows.open(2, 3)[kWidth + 5] = 7;
  rows.clear();
  rows.open(1, 2);
  rows.clear();
  EXPECT_EQ(rows.open(2, 8)[kWidth + 5], 0);
  EXPECT_TRUE(rows.is_zero());
}

TEST(TileRows, KeepWhatSeveralTermsOfATileAdd) {
  TileRows rows(3);
  rows.open(3, 2)[2 * kWidth + 1] += 1;
  rows.open(1, 2)[0] += 2;
  EXPECT_FALSE(rows.is_zero());
  rows.clear();
  for (std::size_t i = 0; i < 3 * kWidth; ++i) EXPECT_EQ(rows.data()[i], 0) << i;
}

TEST(TileRows, AreZeroWhereNoTermHasAsked) {
  TileRows rows(3);
  EXPECT_TRUE(rows.is_zero());
}

}  // namespace
}  // namespace netloft
