// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/drawn_line.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::pictures {

void draw_line(const StraightLine& line, Image& image) {
  const double dx = line.x1 - line.x0, dy = line.y1 - line.y0, square = dx * dx + dy * dy;
  const double around = line.width / 2 + 1;  // half width of the band of pixels that the line may touch
  const auto pixel = [](double x, std::size_t most) {
    return static_cast<std::size_t>(std::clamp(x, 0.0, static_cast<double>(most)));
  };
  const auto [left, right] = std::minmax(line.x0, line.x1);
  const auto [top, bottom] = std::minmax(line.y0, line.y1);
  for (std::size_t y = pixel(top - around, image.height); y < pixel(bottom + around + 1, image.height); ++y)
    for (std::size_t x = pixel(left - around, image.width); x < pixel(right + around + 1, image.width); ++x) {
      const double px = static_cast<double>(x) + 0.5 - line.x0, py = static_cast<double>(y) + 0.5 - line.y0;
      const double s = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0;
      const double cover = std::clamp(line.width / 2 + 0.5 - std::hypot(px - s * dx, py - s * dy), 0.0, 1.0);
      Colour mixed = image.at(x, y);
      for (std::size_t k = 0; k < 3; ++k) mixed[k] += static_cast<float>(cover) * (line.colour[k] - mixed[k]);
      if (cover > 0) image.set(x, y, mixed);
    }
}

}  // namespace netloft::pictures
