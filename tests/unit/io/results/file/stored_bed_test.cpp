// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/stored_shape.hpp"

#include <gtest/gtest.h>

namespace netloft::results {
namespace {

TEST(StoredBed, IsAPlaneWithoutARelief) {
  const StoredBed bed{.depth = 50, .slope_x = 0.1, .slope_y = -0.2};
  EXPECT_DOUBLE_EQ(bed.height(10, 20), -50 + 1 - 4);
}

TEST(StoredBed, IsStraightBetweenTheHeightsOfItsRelief) {
  const StoredBed bed{.depth = 50, .relief_x = {0, 10, 20}, .relief_y = {0, 4}, .relief = {0, 0, 2, 6, 0, 0}};
  EXPECT_DOUBLE_EQ(bed.height(10, 0), -48);
  EXPECT_DOUBLE_EQ(bed.height(10, 2), -46);
  EXPECT_DOUBLE_EQ(bed.height(5, 4), -47);
  EXPECT_DOUBLE_EQ(bed.height(17.5, 0), -49.5);
}

TEST(StoredBed, GoesOnBeyondItsReliefAsAtItsEdge) {
  const StoredBed bed{
      .depth = 50, .slope_x = 0.1, .relief_x = {0, 10}, .relief_y = {0, 4}, .relief = {1, 2, 3, 4}};
  EXPECT_DOUBLE_EQ(bed.height(20, 9), -50 + 2 + 4);
  EXPECT_DOUBLE_EQ(bed.height(-10, -9), -50 - 1 + 1);
}

}  // namespace
}  // namespace netloft::results
