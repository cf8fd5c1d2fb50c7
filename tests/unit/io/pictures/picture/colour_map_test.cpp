// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/colour_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::pictures {
namespace {

/// Relative luminance (WCAG 2.1), which determines the grey of a print.
double luminance(const Colour& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
}

TEST(ColourMap, BecomesBrighterAllAlongSoThatItSurvivesGreyPrinting) {
  for (int i = 1; i <= 100; ++i)
    EXPECT_GT(luminance(colour_at(i / 100.0)), luminance(colour_at((i - 1) / 100.0))) << i;
}

}  // namespace
}  // namespace netloft::pictures
