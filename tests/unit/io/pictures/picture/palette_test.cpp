// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/palette.hpp"

#include "io/pictures/picture/png.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace netloft::pictures {
namespace {

/// A picture with as many colours as pixels.
Image gradient(std::size_t size) {
  Image image(size, size, {0, 0, 0});
  for (std::size_t y = 0; y < size; ++y)
    for (std::size_t x = 0; x < size; ++x)
      image.set(x, y,
                {static_cast<float>(x) / static_cast<float>(size),
                 static_cast<float>(y) / static_cast<float>(size), 0.5f});
  return image;
}

TEST(Palette, KeepsTheColoursOfAPictureThatHasFew) {
  Image image(3, 1, {1, 0, 0});
  image.set(1, 0, {0, 1, 0});
  const Palette palette = palette_of(image);
  ASSERT_EQ(palette.colours.size(), 2u);
  EXPECT_EQ(palette.colours[palette.pixels[0]], (Palette::Rgb{255, 0, 0}));
  EXPECT_EQ(palette.colours[palette.pixels[1]], (Palette::Rgb{0, 255, 0}));
  EXPECT_EQ(palette.pixels[0], palette.pixels[2]);
}

TEST(Palette, IsNearEveryPixelOfAPictureWithMany) {
  const Image image = gradient(100);
  const Palette palette = palette_of(image);
  EXPECT_EQ(palette.colours.size(), 256u);
  for (std::size_t i = 0; i < palette.pixels.size(); ++i)
    for (std::size_t k = 0; k < 3;
         ++k)  // 256 boxes divide a square of 256 by 256: most sides are 16, some 32
      EXPECT_LE(std::abs(int{image.bytes[3 * i + k]} - int{palette.colours[palette.pixels[i]][k]}), 20);
}

TEST(Palette, OfNothingIsNothing) { EXPECT_TRUE(palette_of(Image(0, 0, {})).pixels.empty()); }

TEST(SmallPng, IsSmallerForAPictureWhosePixelsAllDiffer) {
  Image image = gradient(300);
  std::uint32_t seed = 1;
  for (auto& byte : image.bytes) byte = static_cast<std::uint8_t>((seed = 1664525 * seed + 1013904223) >> 24);
  EXPECT_LT(2 * small_png(image).size(), png(image).size());
}

}  // namespace
}  // namespace netloft::pictures
