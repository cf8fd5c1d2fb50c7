// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "tests/validation/real_gears/neutral_case.hpp"

#include <span>

namespace netloft::real_gears {

/// Forces out of balance at nodes, computed as in FEMNET: components along fixed axes are left out, and
/// forces on a plane of symmetry count for both sides.
struct OutOfBalance {
  double mean = 0;               // mean over all nodes of the norm [N]
  double largest_component = 0;  // [N]
};
OutOfBalance out_of_balance(const NeutralCase& gear, const Assembler& assembler,
                            std::span<const double> residual);

/// Positions of nodes from a vector over all degrees of freedom, and the reverse.
std::vector<Vector> nodal(const NeutralCase& gear, const Assembler& assembler, std::span<const double> x);
std::vector<double> over_dofs(const Assembler& assembler, const std::vector<Vector>& positions);

double distance(const Vector& a, const Vector& b);

/// The node that is furthest from its position in the reference.
struct Furthest {
  double distance = 0;  // [m]
  std::uint32_t node = 0;
};
Furthest furthest(const std::vector<Vector>& positions, const std::vector<Vector>& reference);

/// Numbers of elements and nodes of a gear in each state (slack, on the bed, …) at positions x.
struct Branches {
  int slack_bars = 0, pressed_bars = 0;  // bars in compression: without stiffness (below 1e-3 of EA), and
                                         // with
  int slack_twines = 0;                  // directions of triangles
  int dry_nodes = 0, nodes_on_bed = 0;
};
Branches branches(const NeutralCase& gear, const std::vector<Vector>& positions);

/// Largest tension of a twine or rope [N].
double largest_tension(const NeutralCase& gear, const std::vector<Vector>& positions);

/// Largest differences between FEMNET's forces and Netloft's, at the positions of FEMNET's answer [N].
struct ForceDifference {
  double bars = 0, twines = 0, reactions = 0;
};
ForceDifference compare_forces(const NeutralCase& gear, Assembler& assembler, std::span<const double> x,
                               std::span<const double> residual);

}  // namespace netloft::real_gears
