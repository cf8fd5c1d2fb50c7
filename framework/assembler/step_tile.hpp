// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/family.hpp"
#include "framework/assembler/request.hpp"
#include "framework/assembler/tile_sums.hpp"

#include <vector>

namespace netloft {

/// The working memory of one thread for the mean forces of a step on one tile.
struct StepTile {
  /// Allocates memory for elements of up to `dofs` degrees of freedom; `dofs` is 0 if no mean forces are
  /// used.
  explicit StepTile(std::size_t dofs)
      : before(dofs * kTileLanes),
        after(before.size()),
        energies(2 * kTileLanes),
        forces(2 * before.size()) {}

  std::vector<double> before, after;  // positions at the ends of the step, [dof][64] [m]
  // Energies and forces of one term at two positions: [2][64] [J], [2][dof][64] [N].
  std::vector<double> energies, forces;
  std::vector<netloft_member> members_before, members, members_after;  // members of each lane
};

/// One family on one tile of elements, in a step of a motion. The forces and tangents in the middle of the
/// step, which have been summed, are corrected to mean forces.
struct TileOfStep {
  const ElementFamily& family;
  const netloft_tile& tile;
  const Request& request;
  bool symmetric;  // the matrix holds its lower triangle only
  TileSums& sums;
  StepTile& step;

  std::size_t dofs() const { return static_cast<std::size_t>(family.type().dofs()); }
  bool has_slope() const { return request.values && request.matrix != MatrixKind::metric; }
  /// Array of forces to add to; nullptr if the request has no forces.
  double* open_force() const { return request.residual ? sums.force.open(dofs(), tile.count) : nullptr; }
  double* open_slope() const { return sums.open_tangent(symmetric, dofs(), tile.count); }
};

}  // namespace netloft
