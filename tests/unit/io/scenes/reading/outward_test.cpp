// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/outward.hpp"

#include <gtest/gtest.h>

namespace netloft::scenes {
namespace {

/// A bag of two triangles, one above the other. The corners of the upper one are counter-clockwise seen from
/// above.
const std::vector<double> kBag{0, 0, 1, 1, 0, 1, 0, 1, 1, 0, 0, -1, 1, 0, -1, 0, 1, -1};

std::vector<double> signs(const std::vector<std::uint32_t>& nodes, bool is_upper_of_plan = false) {
  Part rider;
  rider.nodes = nodes;
  const Outward found = find_outward({{0, is_upper_of_plan}, {3, false}}, kBag, rider);
  EXPECT_EQ(found.unknown, 0);
  return found.of_triangles;
}

TEST(Outward, IsTheSideAwayFromTheMiddleHoweverAPanelIsDrawn) {
  EXPECT_EQ(signs({0, 1, 2, 3, 5, 4}), (std::vector<double>{1, 1}));
  EXPECT_EQ(signs({0, 1, 2, 3, 4, 5}), (std::vector<double>{1, -1}));
  EXPECT_EQ(signs({0, 2, 1, 3, 4, 5}), (std::vector<double>{-1, -1}));
}

TEST(Outward, IsKnownOfThePanelsOfAPlanAndFoundForThoseDrawnBesideThem) {
  EXPECT_EQ(signs({0, 2, 1, 3, 4, 5}, true), (std::vector<double>{1, -1}));
}

TEST(Outward, IsUnknownOfPanelsInOnePlane) {
  Part rider;
  rider.nodes = {0, 1, 2, 0, 2, 1};
  const Outward found = find_outward({{0, false}, {3, false}}, kBag, rider);
  EXPECT_EQ(found.of_triangles, (std::vector<double>{1, 1}));
  EXPECT_EQ(found.unknown, 2);
}

TEST(Outward, OfTrianglesThatStandOnPointsIsThatOfTheirCorners) {
  Part rider;
  rider.nodes = {0, 2, 1};
  EXPECT_EQ(find_outward({}, kBag, rider).of_triangles, (std::vector<double>{1}));
}

}  // namespace
}  // namespace netloft::scenes
