// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/drawn_text.hpp"

#include <gtest/gtest.h>

namespace netloft::pictures {
namespace {

constexpr Colour kBlack{0, 0, 0}, kPaper{1, 1, 1};

/// Sum of darkness over an image, in pixels.
double ink_of(const std::string& text, double size, double x = 10) {
  Image image(200, 60, kPaper);
  write_text(image, x, 40, text, size, kBlack);
  double ink = 0;
  for (const auto byte : image.bytes) ink += (255 - byte) / 765.0;
  return ink;
}

TEST(Text, IsAsWideAsItsLetters) {
  EXPECT_GT(text_width("mm", 20), 1.9 * text_width("m", 20));
  EXPECT_GT(text_width("m", 20), 2 * text_width("i", 20));
  EXPECT_NEAR(text_width("netting", 40), 2 * text_width("netting", 20), 1e-3);
}

TEST(Text, HasTheSignsOfTechnicalTexts) {
  const double missing = ink_of("\xef\xbf\xbd", 20);
  for (const std::string sign : {"±", "²", "°", "…", "é", "ø", "Δ", "ρ", "→", "≤", "–"})
    EXPECT_NE(ink_of(sign, 20), missing) << sign;
}

TEST(Text, SurvivesBytesThatAreNoText) {
  for (const std::string bad : {"\xff\xfe", "\xc3", "\xe2\x82", "\xf0\x9f\x98", "\x80"})
    EXPECT_GT(ink_of(bad, 20), 1);
}

TEST(Text, IsCutAtTheEdgesOfThePicture) {
  EXPECT_GT(ink_of("netting", 20, 180), 0);
  EXPECT_EQ(ink_of("netting", 20, 500), 0);
  EXPECT_EQ(ink_of("netting", 20, -500), 0);
}

}  // namespace
}  // namespace netloft::pictures
