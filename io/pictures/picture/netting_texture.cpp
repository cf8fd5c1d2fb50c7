// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/picture/netting_texture.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::pictures {

namespace {

constexpr std::size_t kSide = 64;  // pixels
constexpr float kTwine = 0.35f;    // brightness of twines

/// The distance of `u` from the nearest integer.
double from_integer(double u) { return std::abs(u - std::round(u)); }

constexpr double kRoundOff = 1e-9;  // rounding error of computed axes

bool repeats(const std::array<double, 4>& axes) {
  return std::all_of(axes.begin(), axes.end(), [](double a) { return from_integer(a) < kRoundOff; });
}

}  // namespace

std::optional<Image> netting_texture(const std::array<double, 4>& axes, double half_width) {
  if (!repeats(axes)) return {};
  const double a = std::round(axes[0]), b = std::round(axes[1]), c = std::round(axes[2]),
               d = std::round(axes[3]);
  if (a * d == b * c) return {};
  Image image(kSide, kSide, {1, 1, 1});
  for (std::size_t row = 0; row < kSide; ++row)
    for (std::size_t column = 0; column < kSide; ++column) {
      const double U = (static_cast<double>(column) + 0.5) / kSide,
                   V = (static_cast<double>(row) + 0.5) / kSide;
      const double off = std::min(from_integer(a * U + b * V), from_integer(c * U + d * V));
      const auto cover = static_cast<float>(std::clamp((half_width - off) * kSide + 0.5, 0.0, 1.0));
      const float light = 1 - cover * (1 - kTwine);
      image.set(column, row, {light, light, light});
    }
  return image;
}

}  // namespace netloft::pictures
