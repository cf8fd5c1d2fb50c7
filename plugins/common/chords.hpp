// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/axial.hpp"

namespace netloft::bars {

constexpr std::size_t at(int row, std::size_t lane) { return static_cast<std::size_t>(row) * kLanes + lane; }

/// Length l, unit vector t and 1/l of the bars of a tile; t and 1/l of a collapsed bar as in axial.hpp.
struct Chords {
  Chords(const netloft_tile& tile, const double (&l0)[kLanes]) {
    const double* x = tile.x;
    for (std::size_t i = 0; i < tile.count; ++i) {
      const double wx = x[at(3, i)] - x[at(0, i)], wy = x[at(4, i)] - x[at(1, i)],
                   wz = x[at(5, i)] - x[at(2, i)];
      l[i] = std::sqrt(wx * wx + wy * wy + wz * wz);
      inverse[i] = 1 / std::max(l[i], axial::kCollapsed * l0[i]);
      t[0][i] = wx * inverse[i], t[1][i] = wy * inverse[i], t[2][i] = wz * inverse[i];
    }
  }
  double l[kLanes] = {}, inverse[kLanes] = {}, t[3][kLanes] = {};
};

}  // namespace netloft::bars
