// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/border_sides.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::gears {

namespace {

double distance_to_side(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  const double x = b[0] - a[0], y = b[1] - a[1], l2 = x * x + y * y;
  const double t = l2 > 0 ? std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / l2, 0.0, 1.0) : 0.0;
  return std::hypot(a[0] + t * x - p[0], a[1] + t * y - p[1]);
}

}  // namespace

BorderSides::BorderSides(const std::vector<PlanePoint>& border, double reach)
    : border_(border), reach_(reach) {
  low_ = high_ = border.front()[1];
  for (const auto& p : border) {
    low_ = std::min(low_, p[1]);
    high_ = std::max(high_, p[1]);
  }
  low_ -= reach;
  high_ += reach;
  bands_.resize(static_cast<std::size_t>((high_ - low_) / reach) + 2);
  for (std::size_t i = 0; i < border.size(); ++i) {
    const auto [a, b] = std::minmax(border[i][1], border[(i + 1) % border.size()][1]);
    for (std::size_t k = band(a - reach); k <= band(b + reach); ++k) bands_[k].push_back(i);
  }
}

bool BorderSides::holds(const PlanePoint& p) const {
  if (p[1] < low_ || p[1] > high_) return false;
  bool is_inside = false;
  for (const std::size_t i : bands_[band(p[1])]) {
    const PlanePoint &a = border_[i], &b = border_[(i + 1) % border_.size()];
    if (distance_to_side(p, a, b) < reach_) return false;
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      is_inside = !is_inside;
  }
  return is_inside;
}

std::size_t BorderSides::band(double y) const {
  const double k = std::clamp((y - low_) / reach_, 0.0, static_cast<double>(bands_.size() - 1));
  return static_cast<std::size_t>(k);
}

}  // namespace netloft::gears
