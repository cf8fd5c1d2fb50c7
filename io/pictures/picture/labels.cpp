// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/labels.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::pictures {

namespace {

constexpr double kOff = 6;  // distance from the line, and from the edges of the picture [pixels]

/// The overlap of two labels [pixels²]. Each label has a margin, because labels that nearly touch look like
/// one label.
double shared(const Frame& a, const Frame& b) {
  constexpr double kApartAcross = 6, kApartDown = 3;
  const double across =
      std::min(a.left + a.width, b.left + b.width) - std::max(a.left, b.left) + kApartAcross;
  const double down = std::min(a.top + a.height, b.top + b.height) - std::max(a.top, b.top) + kApartDown;
  return across > 0 && down > 0 ? across * down : 0;
}

double within(double at, double lo, double hi) { return std::max(lo, std::min(at, hi)); }

Frame beside(const LabelledLine& line, double size, double along, bool to_the_right, const Frame& picture) {
  const double x = std::lerp(line.from[0], line.to[0], along), y = std::lerp(line.from[1], line.to[1], along);
  const double left = to_the_right ? x + kOff : x - kOff - line.words;
  return {within(left, picture.left + kOff, picture.left + picture.width - kOff - line.words),
          within(y - kOff - size, picture.top, picture.top + picture.height - size), line.words, size};
}

Frame free_place(const LabelledLine& line, double size, const Frame& picture,
                 const std::vector<Frame>& before) {
  Frame best{};
  double least = INFINITY;
  for (const double along : {0.5, 0.22, 0.78, 0.36, 0.64, 0.08, 0.92})
    for (const bool to_the_right : {true, false}) {
      const Frame place = beside(line, size, along, to_the_right, picture);
      double sum = 0;
      for (const Frame& other : before) sum += shared(place, other);
      if (sum < least) {
        least = sum;
        best = place;
      }
    }
  return best;
}

}  // namespace

std::vector<Frame> place_labels(const std::vector<LabelledLine>& lines, double size, const Frame& picture) {
  std::vector<Frame> places;
  for (const auto& line : lines) places.push_back(free_place(line, size, picture, places));
  return places;
}

}  // namespace netloft::pictures
