// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/pixel_picture.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace netloft::pictures {
namespace {

/// Width and height in the header of a PNG file: four bytes each from the 17th on.
std::array<unsigned, 2> size_of(const std::string& png) {
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(png[i]);
    return value;
  };
  return {number(16), number(20)};
}

TEST(PixelPicture, HasTheWidthThatIsWanted) {
  PixelPicture picture;
  picture.line({0, 0}, {100, 50}, "#222", 2);
  picture.text({10, 20}, "headline", 12, "#0b5fa5", formats::Anchor::middle);
  const std::string png = picture.finish({100, 50}, 400);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(size_of(png), (std::array<unsigned, 2>{400, 200}));
}

TEST(PixelPicture, RefusesToBeTooHigh) {
  const PixelPicture picture;
  EXPECT_THROW(picture.finish({100, 1e9}, 2200), std::invalid_argument);
}

TEST(Line, CoversThePixelsBesideIt) {
  Image image(20, 20, {1, 1, 1});
  draw_line({2, 10, 18, 10, 4, {0, 0, 0}}, image);
  EXPECT_EQ(image.at(10, 9), (Colour{0, 0, 0}));
  EXPECT_EQ(image.at(10, 10), (Colour{0, 0, 0}));
  EXPECT_EQ(image.at(10, 14), (Colour{1, 1, 1}));
  EXPECT_EQ(image.at(10, 5), (Colour{1, 1, 1}));
}

TEST(ColourMap, ReadsTheColoursOfDrawings) {
  EXPECT_EQ(hex(colour_of("#0b5fa5")), "#0b5fa5");
  EXPECT_EQ(hex(colour_of("#27c")), "#2277cc");
}

}  // namespace
}  // namespace netloft::pictures
