// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "tests/validation/real_gears/neutral_case.hpp"

#include <span>

namespace netloft::real_gears {

/// How far from balance nodes are, as FEMNET counts it: fixed components left out, those on a plane of
/// symmetry for both sides of it.
struct OutOfBalance {
  double mean = 0;               // over all nodes, of the norm [N]
  double largest_component = 0;  // [N]
};
OutOfBalance out_of_balance(const NeutralCase& gear, const Assembler& assembler,
                            std::span<const double> residual);

/// Positions of the nodes out of a vector over all degrees of freedom, and back.
std::vector<Vector> nodal(const NeutralCase& gear, const Assembler& assembler, std::span<const double> x);
std::vector<double> over_dofs(const Assembler& assembler, const std::vector<Vector>& positions);

double distance(const Vector& a, const Vector& b);

/// The node that lies furthest from where the reference has it.
struct Furthest {
  double distance = 0;  // [m]
  std::uint32_t node = 0;
};
Furthest furthest(const std::vector<Vector>& positions, const std::vector<Vector>& reference);

/// Which of their branches a gear's elements and nodes are in at positions x.
struct Branches {
  int slack_bars = 0, pressed_bars = 0;  // in compression: without stiffness (below 1e-3 of EA), with
  int slack_twines = 0;                  // directions of triangles
  int dry_nodes = 0, nodes_on_bed = 0;
};
Branches branches(const NeutralCase& gear, const std::vector<Vector>& positions);

/// Largest tension of a twine or rope [N].
double largest_tension(const NeutralCase& gear, const std::vector<Vector>& positions);

/// Forces of FEMNET's reference and of ours where it stands, worst differences [N].
struct ForceDifference {
  double bars = 0, twines = 0, reactions = 0;
};
ForceDifference compare_forces(const NeutralCase& gear, Assembler& assembler, std::span<const double> x,
                               std::span<const double> residual);

}  // namespace netloft::real_gears
