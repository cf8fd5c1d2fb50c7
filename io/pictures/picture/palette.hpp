// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/canvas.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace netloft::pictures {

/// A picture with at most 256 colours.
struct Palette {
  using Rgb = std::array<std::uint8_t, 3>;
  std::vector<Rgb> colours;
  std::vector<std::uint8_t> pixels;  // the index of a colour, row by row
};

/// Reduces a picture to similar colours: boxes of colours are halved at the median of their longest side (P.
/// Heckbert, Color image quantization for frame buffer display, SIGGRAPH 1982).
Palette palette_of(const Image& image);

}  // namespace netloft::pictures
