// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/ship.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace netloft::results {
namespace {

TEST(HullOfAShip, IsAheadOfItsBlocksAndAsWideAsItsBeam) {
  const auto corners = triangles_of({{3, 2, 4}, 8});
  ASSERT_EQ(corners.size() % 3, 0u);
  std::array<double, 3> lo{INFINITY, INFINITY, INFINITY}, hi{-INFINITY, -INFINITY, -INFINITY};
  for (const auto& corner : corners)
    for (std::size_t k = 0; k < 3; ++k)
      lo[k] = std::min(lo[k], corner[k]), hi[k] = std::max(hi[k], corner[k]);
  EXPECT_EQ(hi[0], 3);
  EXPECT_EQ((std::array{lo[1], hi[1]}), (std::array{-2.0, 6.0}));
  EXPECT_LT(lo[2], 0);  // the keel is in the water
}

TEST(HullOfAShip, HasNoHoleInItsSides) {
  // In a closed surface every side of a triangle belongs to two triangles.
  const auto corners = triangles_of({{0, 0, 2}, 6});
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[i % 3 == 2 ? i - 2 : i + 1];
    int shared = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto &c = corners[k], &d = corners[k % 3 == 2 ? k - 2 : k + 1];
      shared += (a == c && b == d) || (a == d && b == c);
    }
    EXPECT_EQ(shared, 2) << "triangle " << i / 3;
  }
}

}  // namespace
}  // namespace netloft::results
