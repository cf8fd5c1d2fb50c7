// SPDX-License-Identifier: BSD-3-Clause
#include "io/picture/colour_map.hpp"

#include "io/result/field_range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace netloft::io {
namespace {

/// Relative luminance (WCAG 2.1), from which a grey print comes.
double luminance(const Colour& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
}

TEST(ColourMap, BecomesBrighterAllAlongSoThatItSurvivesGreyPrinting) {
  for (int i = 1; i <= 100; ++i)
    EXPECT_GT(luminance(colour_at(i / 100.0)), luminance(colour_at((i - 1) / 100.0))) << i;
}

TEST(ColourMap, IsTheSameInPagesAndPictures) {
  std::ifstream file(std::string(NETLOFT_SOURCE_DIR) + "/io/view/page/colours.js");
  std::stringstream text;
  text << file.rdbuf();
  for (int i = 0; i <= 8; ++i) EXPECT_NE(text.str().find(hex(colour_at(i / 8.0))), std::string::npos) << i;
  for (std::uint32_t part = 0; part < 8; ++part)
    EXPECT_NE(text.str().find(hex(colour_of_part(part))), std::string::npos) << part;
}

TEST(ColourScale, GoesFromItsEndsToZeroAndOneAndBack) {
  for (const bool logarithmic : {false, true}) {
    const ColourScale scale(2, 200, logarithmic);
    EXPECT_NEAR(scale.place(2), 0, 1e-12);
    EXPECT_NEAR(scale.place(200), 1, 1e-12);
    EXPECT_NEAR(scale.value(scale.place(30)), 30, 1e-9);
  }
  EXPECT_NEAR(ColourScale(2, 200, true).value(0.5), 20, 1e-9);
}

TEST(ColourScale, HasAPlaceForEveryNumberOfAConstantField) {
  EXPECT_TRUE(std::isfinite(ColourScale(3, 3, false).place(3)));
  EXPECT_TRUE(std::isfinite(ColourScale(0, 0, true).place(0)));
  EXPECT_TRUE(std::isfinite(ColourScale(-5, 10, true).place(-5)));
}

TEST(FieldRange, LeavesOutWhatIsNotKnownAndBeginsAboveTheLeastFiftieth) {
  FieldRange range;
  std::vector<double> values = {NAN, 1e-9};
  for (int i = 1; i < 100; ++i) values.push_back(i);
  range.take(values);
  EXPECT_EQ(range.lo(), 1e-9);
  EXPECT_EQ(range.hi(), 99);
  EXPECT_EQ(range.low(), 2);  // of 100 values two lie below: 1e-9 and 1
  EXPECT_FALSE(FieldRange().is_known());
}

}  // namespace
}  // namespace netloft::io
