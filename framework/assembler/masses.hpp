// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/tile_evaluator.hpp"

#include <array>

namespace netloft {

/// The diagonal blocks of the mass matrix ∂r/∂a, summed directly from the tangents of the elements (no sparse
/// matrix is needed). Explicit schemes solve with these blocks.
struct MassBlocks {
  std::span<double> nodes;    // for each node a 3 x 3 block, row by row [kg]
  std::span<double> between;  // a 3 x 3 block per body, origin x rotation [kg]
  double coupled = 0;         // largest entry of the mass matrix that is in no block [kg]
};

/// Adds the masses of all elements at x. `bodies` has two nodes per body, its origin and its rotation.
/// Returns false if an element could not be evaluated: see elements.fault().
bool add_masses(TileEvaluator& elements, std::span<const std::array<std::uint32_t, 2>> bodies,
                std::span<const double> x, MassBlocks& masses);

/// M ← Qᵀ M Q for a block of a node with axes Q, both row by row.
void turn_mass(const std::array<double, 9>& Q, double* M);

}  // namespace netloft
