// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/pixel_picture.hpp"

#include "io/pictures/picture/drawn_text.hpp"
#include "io/pictures/picture/png.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace netloft::pictures {

namespace {

constexpr double kMostPixels = 1.5e8;  // a picture with more would take more than half a gigabyte of memory

}  // namespace

void PixelPicture::line(formats::PicturePoint from, formats::PicturePoint to, const char* colour,
                        double width) {
  lines_.push_back({from.x, from.y, to.x, to.y, width, colour_of(colour)});
}

void PixelPicture::text(formats::PicturePoint at, const std::string& text, double size, const char* colour,
                        formats::Anchor anchor) {
  words_.push_back({at, text, size, colour_of(colour), anchor});
}

void PixelPicture::write(const Words& words, double scale, Image& image) {
  const double size = scale * words.size, width = text_width(words.text, size);
  const double back = words.anchor == formats::Anchor::end      ? width
                      : words.anchor == formats::Anchor::middle ? width / 2
                                                                : 0;
  write_text(image, scale * words.at.x - back, scale * words.at.y, words.text, size, words.colour);
}

std::string PixelPicture::finish(formats::DrawingSize size, double pixels) const {
  const double scale = pixels / size.width, height = std::ceil(scale * size.height);
  if (pixels * height > kMostPixels)
    throw std::invalid_argument(
        fmt::format("the picture would have {:.0f} x {:.0f} pixels; give a smaller --width, or write .svg",
                    pixels, height));
  Image image(static_cast<std::size_t>(pixels), static_cast<std::size_t>(height), {1, 1, 1});
  for (const auto& l : lines_)
    draw_line({scale * l.x0, scale * l.y0, scale * l.x1, scale * l.y1, scale * l.width, l.colour}, image);
  for (const auto& words : words_) write(words, scale, image);
  return png(image);
}

}  // namespace netloft::pictures
