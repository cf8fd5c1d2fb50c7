// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/triangle.hpp"

namespace netloft::priour {

/// Computes the vector Σ c_p x_p of a bar, triangle.hpp (2) or (3), for every element [m]. The positions are
/// x + x_low, where x_low holds digits beyond those of a double; a tile may lack x_low.
inline void find_spans(const netloft_tile& t, const double (&c)[3][kLanes],
                       double (&__restrict w)[3][kLanes]) {
  for (int axis = 0; axis < 3; ++axis) {
    const double *x0 = t.x + at(axis, 0), *x1 = t.x + at(axis + 3, 0), *x2 = t.x + at(axis + 6, 0);
    if (!t.x_low) {
      for (std::size_t i = 0; i < t.count; ++i)
        w[axis][i] = c[0][i] * x0[i] + c[1][i] * x1[i] + c[2][i] * x2[i];
      continue;
    }
    const double *low0 = t.x_low + at(axis, 0), *low1 = t.x_low + at(axis + 3, 0),
                 *low2 = t.x_low + at(axis + 6, 0);
    for (std::size_t i = 0; i < t.count; ++i)
      w[axis][i] = c[1][i] * ((x1[i] - x0[i]) + (low1[i] - low0[i])) +
                   c[2][i] * ((x2[i] - x0[i]) + (low2[i] - low0[i]));
  }
}

/// Unit vector and 1/length of a bar of one direction, for every element. If a bar is shorter than kCollapsed
/// l₀, both are finite substitutes, as in axial.hpp. `c` is a of triangle.hpp (2) or b of (3).
struct Twines {
  Twines(const netloft_tile& tile, const double (&c)[3][kLanes], const double (&l0)[kLanes]) {
    find_spans(tile, c, t);
    for (std::size_t i = 0; i < tile.count; ++i) {
      const double wx = t[0][i], wy = t[1][i], wz = t[2][i];
      const double l = std::sqrt(wx * wx + wy * wy + wz * wz);
      inverse[i] = 1 / std::max(l, axial::kCollapsed * l0[i]);
      t[0][i] = inverse[i] * wx;
      t[1][i] = inverse[i] * wy;
      t[2][i] = inverse[i] * wz;
    }
  }
  bool collapsed(std::size_t lane, double l0) const { return inverse[lane] * axial::kCollapsed * l0 >= 1; }

  double t[3][kLanes];
  double inverse[kLanes];  // [1/m]
};

/// An entry of a tile's input; zero if the input is absent.
inline double entry(const double* field, int row, std::size_t lane) {
  return field ? field[at(row, lane)] : 0;
}

/// Mean of a field of the three corners along an axis.
inline double mean_of_corners(const double* field, int axis, std::size_t lane) {
  return field ? (field[at(axis, lane)] + field[at(axis + 3, lane)] + field[at(axis + 6, lane)]) / 3 : 0;
}

/// Index of (corner p, axis r; corner q, axis c) in a full tangent.
constexpr int place(int p, int r, int q, int c) { return 9 * (3 * p + r) + 3 * q + c; }

}  // namespace netloft::priour
