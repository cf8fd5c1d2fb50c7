// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/canvas.hpp"

#include <gtest/gtest.h>

namespace netloft::pictures {
namespace {

constexpr Colour kRed{1, 0, 0}, kBlue{0, 0, 1}, kWhite{1, 1, 1};

TEST(Canvas, ShowsWhatIsNearerInWhateverOrderItIsDrawn) {
  for (const bool red_first : {true, false}) {
    Canvas canvas(2, 1);
    canvas.add(0, 0, red_first ? 1 : 2, red_first ? kRed : kBlue, 1);
    canvas.add(0, 0, red_first ? 2 : 1, red_first ? kBlue : kRed, 1);
    EXPECT_EQ(canvas.resolve(0, 0, kWhite), kBlue);
    EXPECT_EQ(canvas.resolve(1, 0, kWhite), kWhite);
  }
}

TEST(Canvas, LaysTranslucentColoursOverOneAnotherFromBackToFront) {
  Canvas canvas(1, 1);
  canvas.add(0, 0, 2, kBlue, 0.5);
  canvas.add(0, 0, 1, kRed, 0.5);
  // White under half-transparent red is (1, 0.5, 0.5), and this colour under half-transparent blue is (0.5,
  // 0.25, 0.75).
  EXPECT_EQ(canvas.resolve(0, 0, kWhite), (Colour{0.5f, 0.25f, 0.75f}));
}

TEST(Canvas, HidesTranslucentColoursBehindOpaqueOnes) {
  Canvas canvas(1, 1);
  canvas.add(0, 0, 1, kRed, 0.5);
  canvas.add(0, 0, 2, kBlue, 1);
  EXPECT_EQ(canvas.resolve(0, 0, kWhite), kBlue);
}

TEST(Canvas, DropsWhatLiesBesideIt) {
  Canvas canvas(1, 1);
  canvas.add(1, 0, 1, kRed, 1);
  canvas.add(0, static_cast<std::size_t>(-1), 1, kRed, 1);
  EXPECT_EQ(canvas.resolve(0, 0, kWhite), kWhite);
}

}  // namespace
}  // namespace netloft::pictures
