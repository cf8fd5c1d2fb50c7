// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/tile_sums.hpp"
#include "framework/assembler/tiling.hpp"

namespace netloft {

// Adds the sums of a tile (64 elements) to the sums of the scene: forces to vectors over all dofs [N],
// tangents to the values of a matrix [N/m]. Moments on bodies are divided by the arm, because the unknowns of
// rotations are lengths.

/// Adds the forces of the tile to `gradient`, and keeps them in the tile, so that further terms can add to
/// them.
void scatter_gradient(const Tiling& tiling, std::size_t tile, TileSums& sums, double* gradient);

/// Adds forces and tangents. May overwrite the arrays of the tile. An argument that is nullptr is skipped.
/// `is_symmetric`: the matrix holds its lower triangle only.
void scatter(const Tiling& tiling, std::size_t tile, bool is_symmetric, TileSums& sums, double* residual,
             double* values);

}  // namespace netloft
