// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::pictures {

namespace {
constexpr float kFar = -std::numeric_limits<float>::infinity();
constexpr double kOpaque = 0.995;
}  // namespace

Image::Image(std::size_t w, std::size_t h, const Colour& colour) : width(w), height(h), bytes(3 * w * h) {
  for (std::size_t y = 0; y < h; ++y)
    for (std::size_t x = 0; x < w; ++x) set(x, y, colour);
}

void Image::set(std::size_t x, std::size_t y, const Colour& colour) {
  for (std::size_t k = 0; k < 3; ++k)
    bytes[3 * (y * width + x) + k] =
        static_cast<std::uint8_t>(std::lround(255 * std::clamp(colour[k], 0.0f, 1.0f)));
}

Colour Image::at(std::size_t x, std::size_t y) const {
  const std::size_t i = 3 * (y * width + x);
  return {static_cast<float>(bytes[i]) / 255, static_cast<float>(bytes[i + 1]) / 255,
          static_cast<float>(bytes[i + 2]) / 255};
}

Canvas::Canvas(std::size_t width, std::size_t height)
    : width_(width), height_(height), first_(width * height, -1), opaque_(width * height, kFar) {}

void Canvas::clear() {
  std::fill(first_.begin(), first_.end(), -1);
  std::fill(opaque_.begin(), opaque_.end(), kFar);
  fragments_.clear();
}

void Canvas::add(std::size_t x, std::size_t y, double depth, const Colour& colour, double alpha) {
  if (x >= width_ || y >= height_ || !(alpha > 0)) return;
  const std::size_t at = y * width_ + x;
  const auto near = static_cast<float>(depth);
  if (near <= opaque_[at]) return;
  if (alpha >= kOpaque) opaque_[at] = near;
  fragments_.push_back({near, static_cast<float>(std::min(alpha, 1.0)), colour, first_[at]});
  first_[at] = static_cast<std::int32_t>(fragments_.size() - 1);
}

Colour Canvas::resolve(std::size_t x, std::size_t y, const Colour& ground) const {
  const std::size_t at = y * width_ + x;
  std::vector<const Fragment*> seen;
  for (std::int32_t i = first_[at]; i >= 0; i = fragments_[static_cast<std::size_t>(i)].next)
    if (const Fragment& f = fragments_[static_cast<std::size_t>(i)]; f.depth >= opaque_[at])
      seen.push_back(&f);
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Fragment* a, const Fragment* b) { return a->depth < b->depth; });
  Colour colour = ground;
  for (const Fragment* f : seen)
    for (std::size_t k = 0; k < 3; ++k) colour[k] += f->alpha * (f->colour[k] - colour[k]);
  return colour;
}

}  // namespace netloft::pictures
