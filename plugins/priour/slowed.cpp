// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/slowed.hpp"

#include <cmath>

namespace netloft::priour {

namespace {

/// A coordinate of the centroid of a triangle. If `with_low`, the positions are x + x_low, as in twines.hpp.
double middle(const netloft_tile& t, bool with_low, int axis, std::size_t i) {
  return mean_of_corners(t.x, axis, i) + (with_low ? mean_of_corners(t.x_low, axis, i) : 0);
}

}  // namespace

Slowing::Slowing(const Triangle::Lanes& p, const netloft_tile& t, std::uint32_t kind_of_law) : acts(p.slows) {
  const bool with_low = kind_of_law == NETLOFT_TWINE_LAW;  // like the positions in drag.hpp
  for (std::size_t i = 0; i < t.count && acts; ++i) {
    const double along =
        p.slowed_x[i] * middle(t, with_low, 0, i) + p.slowed_y[i] * middle(t, with_low, 1, i);
    const double d = p.slowed_front[i] - along, b = p.slowed_by[i], R = p.slowed_radius[i];
    left[i] = 1 - b;
    x[i] = y[i] = 0;
    if (!(d > 0)) continue;
    const double near = 1 + d * d / (R * R), root = std::sqrt(near);
    left[i] = 1 - b / (near * root);                                   // (2)
    const double slope = -3 * b * d / (R * R) / (near * near * root);  // (3)
    x[i] = slope * p.slowed_x[i];
    y[i] = slope * p.slowed_y[i];
  }
}

}  // namespace netloft::priour
