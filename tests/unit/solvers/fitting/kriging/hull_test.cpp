// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/fitting/kriging/hull.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace netloft {
namespace {

using Points = std::vector<std::vector<double>>;

TEST(Hull, HasWhatLiesBetween) {
  const Points triangle{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_TRUE(lies_in_hull(triangle, {0.2, 0.3}));
  EXPECT_TRUE(lies_in_hull(triangle, {0.5, 0.5}));
  EXPECT_TRUE(lies_in_hull(triangle, {1, 0}));
  EXPECT_FALSE(lies_in_hull(triangle, {0.5, 0.5001}));
  EXPECT_FALSE(lies_in_hull(triangle, {-0.0001, 0.5}));
  EXPECT_FALSE(lies_in_hull({}, {0, 0}));
}
TEST(Hull, OfPointsOnALineIsTheLine) {
  const Points line{{0, 0}, {0.5, 0.5}, {1, 1}};
  EXPECT_TRUE(lies_in_hull(line, {0.3, 0.3}));
  EXPECT_FALSE(lies_in_hull(line, {0.3, 0.4}));
  EXPECT_FALSE(lies_in_hull(line, {1.1, 1.1}));
}
// The corners of a cube of four dimensions, and random points: a point is outside if one coordinate is.
TEST(Hull, OfCornersIsTheCube) {
  Points cube;
  for (int corner = 0; corner < 16; ++corner) {
    std::vector<double> at;
    for (int j = 0; j < 4; ++j) at.push_back(corner >> j & 1);
    cube.push_back(at);
  }
  std::mt19937_64 dice(3);
  for (int i = 0; i < 200; ++i) cube.push_back({0.1, 0.2 + 0.001 * i, 0.5, 0.5});
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> at;
    bool inside = true;
    for (int j = 0; j < 4; ++j) {
      at.push_back(-0.2 + 1.4 * static_cast<double>(dice() >> 11) * 0x1p-53);
      inside = inside && at.back() >= 0 && at.back() <= 1;
    }
    EXPECT_EQ(lies_in_hull(cube, at), inside) << trial;
  }
}

}  // namespace
}  // namespace netloft
