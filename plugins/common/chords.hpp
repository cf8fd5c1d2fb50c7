// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/axial.hpp"

namespace netloft::bars {

constexpr std::size_t at(int row, std::size_t lane) { return static_cast<std::size_t>(row) * kLanes + lane; }

/// Computes x₁ − x₀ of the bars of a tile [m]. Positions are x + x_low, where x_low holds digits beyond those
/// of a double; a tile may lack x_low.
inline void find_spans(const netloft_tile& t, double (&__restrict w)[3][kLanes]) {
  for (int axis = 0; axis < 3; ++axis) {
    const double *first = t.x + at(axis, 0), *second = t.x + at(axis + 3, 0);
    for (std::size_t i = 0; i < t.count; ++i) w[axis][i] = second[i] - first[i];
  }
  if (!t.x_low) return;
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < t.count; ++i) w[axis][i] += t.x_low[at(axis + 3, i)] - t.x_low[at(axis, i)];
}

/// Length l, unit vector t and 1/l of the bars of a tile; for bars of almost no length, t and 1/l are the
/// finite substitutes described in axial.hpp.
struct Chords {
  Chords(const netloft_tile& tile, const double (&l0)[kLanes]) {
    find_spans(tile, t);
    for (std::size_t i = 0; i < tile.count; ++i) {
      const double wx = t[0][i], wy = t[1][i], wz = t[2][i];
      l[i] = std::sqrt(wx * wx + wy * wy + wz * wz);
      inverse[i] = 1 / std::max(l[i], axial::kCollapsed * l0[i]);
      t[0][i] = wx * inverse[i];
      t[1][i] = wy * inverse[i];
      t[2][i] = wz * inverse[i];
    }
  }
  double l[kLanes] = {}, inverse[kLanes] = {}, t[3][kLanes] = {};
};

}  // namespace netloft::bars
