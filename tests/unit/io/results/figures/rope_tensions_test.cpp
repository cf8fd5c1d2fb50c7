// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/rope_tensions.hpp"

#include <gtest/gtest.h>

namespace netloft::results::test {
namespace {

// The middles of the bars are at 0.5, 2 and 4 m.
const RopeTensions kRope{"rope", {10, 40, 20}, {1, 2, 2}};

TEST(RopeTensions, AreLinearBetweenTheMiddlesOfBars) {
  EXPECT_DOUBLE_EQ(kRope.at(0.5), 10);
  EXPECT_DOUBLE_EQ(kRope.at(1.25), 25);
  EXPECT_DOUBLE_EQ(kRope.at(3), 30);
}

TEST(RopeTensions, AreHeldInTheOuterHalvesOfTheOuterBars) {
  EXPECT_DOUBLE_EQ(kRope.at(0), 10);
  EXPECT_DOUBLE_EQ(kRope.at(4.9), 20);
}

TEST(RopeTensions, CanBeSeenFromTheOtherEnd) {
  for (const double distance : {0.3, 1.0, 2.2, 4.7})
    EXPECT_NEAR(kRope.turned_round().at(distance), kRope.at(5 - distance), 1e-12);
}

}  // namespace
}  // namespace netloft::results::test
