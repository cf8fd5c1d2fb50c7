// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/insertion_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace netloft::gears {
namespace {

TEST(HilbertOrder, StepsFromEachPointOfAGridToANeighbour) {
  constexpr int kSide = 32;
  std::vector<PlanePoint> grid;
  for (int x = 0; x < kSide; ++x)
    for (int y = 0; y < kSide; ++y) grid.push_back({x + 0.5 * (x == kSide - 1), y + 0.5 * (y == kSide - 1)});
  const auto order = hilbert_order(grid);
  EXPECT_EQ(std::set(order.begin(), order.end()).size(), grid.size());
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const PlanePoint &p = grid[order[i]], &q = grid[order[i + 1]];
    EXPECT_LE(std::hypot(p[0] - q[0], p[1] - q[1]), 1.5);
  }
}

}  // namespace
}  // namespace netloft::gears
