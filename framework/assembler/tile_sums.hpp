// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/lanes.hpp"
#include "framework/assembler/tile_rows.hpp"

#include <algorithm>
#include <vector>

namespace netloft {

/// The sums of energies, forces and tangents over the terms of one tile, in rows of 64 numbers. Tangents of
/// symmetric terms are packed lower triangles; all other tangents are full squares, row by row.
struct TileSums {
  /// Allocates memory for elements of up to `dofs` degrees of freedom. If all matrices are symmetric, no
  /// square tangents are allocated.
  TileSums(std::size_t dofs, bool symmetric)
      : force(dofs),
        packed_tangent(packed(dofs)),
        square_tangent(symmetric ? 0 : dofs * dofs),
        scratch(dofs * dofs * kTileLanes),
        element(dofs * dofs) {}

  void begin(bool with_energy) {
    if (with_energy) std::fill_n(energy, kTileLanes, 0.0);
    force.begin();
    packed_tangent.begin();
    square_tangent.begin();
  }
  double* open_tangent(bool symmetric, std::size_t dofs, std::size_t lanes) {
    return symmetric ? packed_tangent.open(packed(dofs), lanes) : square_tangent.open(dofs * dofs, lanes);
  }

  double energy[kTileLanes] = {};  // [J]
  TileRows force;                  // [N]
  TileRows packed_tangent, square_tangent;
  std::vector<double> scratch;  // a tangent in rows of 64, to be converted and added
  std::vector<double> element;  // the tangent of one element, row by row
};

}  // namespace netloft
