// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/pictures/picture/colour_map.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace netloft::pictures {

/// Red, green and blue bytes, row by row from the upper left corner.
struct Image {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> bytes;

  Image(std::size_t w, std::size_t h, const Colour& colour);
  void set(std::size_t x, std::size_t y, const Colour& colour);
  Colour at(std::size_t x, std::size_t y) const;
};

/// Collects the fragments of every pixel, translucent or opaque, with their depths, so that the order of
/// drawing does not matter. A pixel has one sample; the painter therefore draws several times with shifted
/// samples, and averages the pictures.
class Canvas {
 public:
  Canvas(std::size_t width, std::size_t height);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  /// Adds colour to a pixel; `depth` increases towards the eye. Fragments behind an opaque one are dropped.
  void add(std::size_t x, std::size_t y, double depth, const Colour& colour, double alpha);
  /// The colour of a pixel: its fragments are composited from back to front over the background colour
  /// `ground`.
  Colour resolve(std::size_t x, std::size_t y, const Colour& ground) const;
  void clear();

 private:
  struct Fragment {
    float depth, alpha;
    Colour colour;
    std::int32_t next;
  };

  std::size_t width_, height_;
  std::vector<std::int32_t> first_;
  std::vector<float> opaque_;  // depth of the nearest opaque fragment
  std::vector<Fragment> fragments_;
};

}  // namespace netloft::pictures
