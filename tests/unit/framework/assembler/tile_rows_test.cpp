// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/tile_rows.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace netloft {
namespace {

constexpr std::size_t kWidth = NETLOFT_LANES;

TEST(TileRows, AreZeroWheneverATileBegins) {
  TileRows rows(4);
  rows.begin(4, 5);
  rows.data()[3 * kWidth + 4] = 1;
  rows.begin(2, kWidth);
  for (std::size_t i = 0; i < 4 * kWidth; ++i) EXPECT_EQ(rows.data()[i], 0) << i;
}

TEST(TileRows, TellWhetherATileHasAddedSomething) {
  TileRows rows(3);
  rows.begin(3, 7);
  EXPECT_TRUE(rows.is_zero());
  rows.begin(3, 7);
  rows.data()[2 * kWidth + 6] = -1e-300;
  EXPECT_FALSE(rows.is_zero());
}

TEST(TileRows, TakeMinusZeroForZeroAndNotANumberForSomething) {
  TileRows rows(1);
  rows.begin(1, 2);
  rows.data()[0] = -0.0;
  EXPECT_TRUE(rows.is_zero());
  rows.begin(1, 2);
  rows.data()[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(rows.is_zero());
}

TEST(TileRows, BeginCleanAfterATileThatAddedNothing) {
  TileRows rows(2);
  rows.begin(2, 3);
  EXPECT_TRUE(rows.is_zero());
  rows.begin(1, 1);
  rows.data()[0] = 5;
  rows.begin(2, 3);
  EXPECT_TRUE(rows.is_zero());
}

}  // namespace
}  // namespace netloft
