// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/board/otter.hpp"

#include <gtest/gtest.h>

namespace netloft::boards {
namespace {

TEST(Ploughing, GrowsWithThePowerOfTheDepth) {
  EXPECT_DOUBLE_EQ(detail::resistance(0.3, 1), 0.3);
  EXPECT_DOUBLE_EQ(detail::resistance(0.3, 2), 0.09);
  EXPECT_DOUBLE_EQ(detail::resistance(1.0, 2), 1);
}

TEST(Ploughing, GrowsAlongItsTangentBeyondATenthOfAMetre) {
  EXPECT_DOUBLE_EQ(detail::resistance(20.0, 2), 39) << "and not with the square, 400";
  EXPECT_DOUBLE_EQ(detail::resistance(20.0, 1), 20) << "in clay as before";
  const double below = detail::resistance(1 - 1e-9, 2), above = detail::resistance(1 + 1e-9, 2);
  EXPECT_NEAR(above - below, 4e-9, 1e-14) << "a slope without a step";
}

}  // namespace
}  // namespace netloft::boards
