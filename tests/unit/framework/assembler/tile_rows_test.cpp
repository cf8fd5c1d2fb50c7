// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/tile_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace netloft {
namespace {

constexpr std::size_t kWidth = NETLOFT_LANES;

/// Fills all rows with ones.
void spoil(TileRows& rows, std::size_t count) {
  rows.begin();
  std::fill_n(rows.open(count, kWidth), count * kWidth, 1.0);
}

TEST(TileRows, AreZeroWhereATermOfTheNextTileOpensThem) {
  TileRows rows(7);
  for (const std::size_t lanes : {1u, 5u, 8u, 9u, 48u, 49u, 63u, 64u}) {
    spoil(rows, 7);
    rows.begin();
    rows.open(3, lanes), rows.open(7, lanes);
    for (std::size_t row = 0; row < 7; ++row)
      for (std::size_t lane = 0; lane < lanes; ++lane)
        EXPECT_EQ(rows.data()[row * kWidth + lane], 0) << row << " " << lane << " of " << lanes;
    EXPECT_TRUE(rows.is_zero());
  }
}

TEST(TileRows, AreZeroInLanesAndRowsThatTheTileBeforeDidNotHave) {
  TileRows rows(6);
  spoil(rows, 6);
  rows.begin();
  rows.open(4, 3);
  EXPECT_TRUE(rows.is_zero());
  rows.begin();
  rows.open(4, 9);
  EXPECT_TRUE(rows.is_zero());
  rows.begin();
  rows.open(6, 9);
  EXPECT_TRUE(rows.is_zero());
}

TEST(TileRows, TellWhetherATileHasAddedSomething) {
  TileRows rows(3);
  rows.begin();
  rows.open(3, 7);
  EXPECT_TRUE(rows.is_zero());
  rows.begin();
  rows.open(3, 7)[2 * kWidth + 6] = -1e-300;
  EXPECT_FALSE(rows.is_zero());
}

TEST(TileRows, TakeMinusZeroForZeroAndNotANumberForSomething) {
  TileRows rows(1);
  rows.begin();
  rows.open(1, 2)[0] = -0.0;
  EXPECT_TRUE(rows.is_zero());
  rows.begin();
  rows.open(1, 2)[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(rows.is_zero());
}

TEST(TileRows, BeginCleanAfterATileThatAddedNothing) {
  TileRows rows(2);
  rows.begin();
  rows.open(2, 3);
  EXPECT_TRUE(rows.is_zero());
  rows.begin();
  rows.open(1, 1)[0] = 5;
  rows.begin();
  rows.open(2, 3);
  EXPECT_TRUE(rows.is_zero());
}

// A plugin must not write beyond the last lane. If it does, other tiles must not be affected.
TEST(TileRows, ForgetWhatWasWrittenBeyondTheLastLane) {
  TileRows rows(2);
  rows.open(2, 3)[kWidth + 5] = 7;
  rows.begin();
  rows.open(1, 2);
  rows.begin();
  EXPECT_EQ(rows.open(2, 8)[kWidth + 5], 0);
  EXPECT_TRUE(rows.is_zero());
}

TEST(TileRows, KeepWhatSeveralTermsOfATileAdd) {
  TileRows rows(3);
  rows.open(3, 2)[2 * kWidth + 1] += 1;
  rows.open(1, 2)[0] += 2;
  EXPECT_FALSE(rows.is_zero());
  EXPECT_EQ(rows.data()[2 * kWidth + 1], 1);
  EXPECT_EQ(rows.data()[0], 2);
}

TEST(TileRows, AreZeroWhereNoTermHasAsked) {
  TileRows rows(3);
  EXPECT_TRUE(rows.is_zero());
}

}  // namespace
}  // namespace netloft
