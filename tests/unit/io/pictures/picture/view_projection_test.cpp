// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/view_projection.hpp"

#include <gtest/gtest.h>

namespace netloft::pictures {
namespace {

const std::vector<Point3> kBox = {{0, -1, -5}, {10, 3, -2}};

TEST(Projection, PutsAftToTheRightAndUpUpwardsFromTheSide) {
  const Projection p = fit(View::side, kBox, {0, 0, 1000, 1000});
  EXPECT_NEAR(p({0, 0, -5})[0], 0, 1e-9);
  EXPECT_NEAR(p({10, 0, -5})[0], 1000, 1e-9);
  EXPECT_LT(p({0, 0, -2})[1], p({0, 0, -5})[1]);
  EXPECT_GT(p({0, -1, 0})[2], p({0, 3, 0})[2]);  // port is nearer to the eye
}

TEST(Projection, PutsPortToTheRightFromAhead) {
  const Projection p = fit(View::front, kBox, {0, 0, 1000, 1000});
  EXPECT_GT(p({0, -1, 0})[0], p({0, 3, 0})[0]);
  EXPECT_GT(p({0, 0, 0})[2], p({10, 0, 0})[2]);
}

TEST(Projection, PutsStarboardUpwardsFromAbove) {
  const Projection p = fit(View::top, kBox, {0, 0, 1000, 1000});
  EXPECT_LT(p({0, 3, 0})[1], p({0, -1, 0})[1]);
  EXPECT_NEAR(p({0, 0, -2})[2] - p({0, 0, -5})[2], 3, 1e-12);
}

TEST(Projection, FitsIntoItsFrameFromEverywhere) {
  for (const View view : {View::side, View::top, View::front, View::oblique}) {
    const Projection p = fit(view, kBox, {100, 50, 300, 200});
    for (const auto& point : kBox) {
      EXPECT_GE(p(point)[0], 100 - 1e-9);
      EXPECT_LE(p(point)[0], 400 + 1e-9);
      EXPECT_GE(p(point)[1], 50 - 1e-9);
      EXPECT_LE(p(point)[1], 250 + 1e-9);
    }
  }
}

TEST(Projection, KnowsItsViewsByNameAndNoOthers) {
  EXPECT_EQ(view_of("front"), View::front);
  EXPECT_FALSE(view_of("below"));
}

}  // namespace
}  // namespace netloft::pictures
