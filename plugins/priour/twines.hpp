// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/triangle.hpp"

namespace netloft::priour {

/// The twines of one direction in every lane: unit vector and 1/length of a bar, or, shorter than axial's
/// kCollapsed l₀, what axial.hpp puts in their place. `c` is a or b of triangle (2), (3).
struct Twines {
  Twines(const netloft_tile& tile, const double (&c)[3][kLanes], const double (&l0)[kLanes]) {
    const double* x = tile.x;
    for (std::size_t i = 0; i < tile.count; ++i) {
      const double c0 = c[0][i], c1 = c[1][i], c2 = c[2][i];
      const double wx = c0 * x[at(0, i)] + c1 * x[at(3, i)] + c2 * x[at(6, i)];
      const double wy = c0 * x[at(1, i)] + c1 * x[at(4, i)] + c2 * x[at(7, i)];
      const double wz = c0 * x[at(2, i)] + c1 * x[at(5, i)] + c2 * x[at(8, i)];
      const double l = std::sqrt(wx * wx + wy * wy + wz * wz);
      inverse[i] = 1 / std::max(l, axial::kCollapsed * l0[i]);
      t[0][i] = inverse[i] * wx, t[1][i] = inverse[i] * wy, t[2][i] = inverse[i] * wz;
    }
  }
  bool collapsed(std::size_t lane, double l0) const { return inverse[lane] * axial::kCollapsed * l0 >= 1; }

  double t[3][kLanes];
  double inverse[kLanes];  // [1/m]
};

/// Entry of a tile's input that may be missing.
inline double entry(const double* field, int row, std::size_t lane) {
  return field ? field[at(row, lane)] : 0;
}

/// Mean of a field of the three corners along an axis.
inline double mean_of_corners(const double* field, int axis, std::size_t lane) {
  return field ? (field[at(axis, lane)] + field[at(axis + 3, lane)] + field[at(axis + 6, lane)]) / 3 : 0;
}

/// Place of (corner p, axis r; corner q, axis c) in a full tangent.
constexpr int place(int p, int r, int q, int c) { return 9 * (3 * p + r) + 3 * q + c; }

}  // namespace netloft::priour
