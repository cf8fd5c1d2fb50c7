// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/labels.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::pictures {
namespace {

constexpr Frame kPicture{0, 50, 800, 400};

bool overlap(const Frame& a, const Frame& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
         b.top < a.top + a.height;
}

TEST(Labels, StandApartWhereLinesCross) {
  std::vector<LabelledLine> lines;
  for (int i = 0; i < 6; ++i) {
    const double x = 100 * std::cos(0.5 * i), y = 100 * std::sin(0.5 * i);
    lines.push_back({{400 - x, 250 - y, 0}, {400 + x, 250 + y, 0}, 150});
  }
  const auto places = place_labels(lines, 13, kPicture);
  ASSERT_EQ(places.size(), lines.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(overlap(places[i].frame, places[k].frame)) << i << " " << k;
}

TEST(Labels, StayInThePicture) {
  const std::vector<LabelledLine> lines = {{{780, 52, 0}, {795, 60, 0}, 120},
                                           {{2, 440, 0}, {20, 449, 0}, 120},
                                           {{790, 445, 0}, {799, 449, 0}, 120}};
  for (const LabelPlace& one : place_labels(lines, 13, kPicture)) {
    const Frame& place = one.frame;
    EXPECT_GE(place.left, kPicture.left);
    EXPECT_LE(place.left + place.width, kPicture.left + kPicture.width);
    EXPECT_GE(place.top, kPicture.top);
    EXPECT_LE(place.top + place.height, kPicture.top + kPicture.height);
  }
}

/// Two lines that are closer than a label is long: each label is off the line of the other.
TEST(Labels, StandOffOtherLines) {
  const std::vector<LabelledLine> lines = {{{300, 100, 0}, {300, 400, 0}, 150},
                                           {{318, 100, 0}, {318, 400, 0}, 150}};
  const auto places = place_labels(lines, 13, kPicture);
  EXPECT_LT(places[0].frame.left + 150, 300);
  EXPECT_GT(places[1].frame.left, 318);
}

TEST(Labels, StandApartWithALeaderWhereTheyWouldHideTheGear) {
  const auto cover = [](const Frame& frame) { return frame.top > 150 && frame.top < 350 ? 1.0 : 0.0; };
  const auto places = place_labels({{{400, 240, 0}, {460, 270, 0}, 120}}, 13, kPicture, cover);
  EXPECT_TRUE(places[0].is_apart);
  EXPECT_EQ(cover(places[0].frame), 0);
  EXPECT_GT(places[0].point[0], 399);
}

TEST(Labels, StandInTheMiddleOfALineOfTheirOwn) {
  const auto places = place_labels({{{100, 200, 0}, {300, 300, 0}, 80}}, 13, kPicture);
  EXPECT_NEAR(places[0].frame.left, 206, 1e-9);
  EXPECT_NEAR(places[0].frame.top + places[0].frame.height, 244, 1e-9);
}

}  // namespace
}  // namespace netloft::pictures
