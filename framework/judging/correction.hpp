// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/static_problem.hpp"

#include <cmath>

namespace netloft {

/// The remaining Newton step at u:
///   K(u) du = −r(u)                                                                     (1)
/// Near an equilibrium, u + du is the equilibrium up to O(|du|²), so that du estimates the error of any
/// solver that ended at u. K is the exact tangent and may be indefinite. Returns false if K has no factor or
/// du is not finite; du is then meaningless. The statistics of `problem` count the cost.
bool find_correction(StaticProblem& problem, std::span<const double> u, std::span<const double> residual,
                     std::span<double> du);

/// Evaluates and factorises K at u. Returns false if K has no factor.
bool factorise_tangent(StaticProblem& problem, std::span<const double> u);

/// Solves (1) with the last factor of the problem, which must be that of K(u). Returns false if no factor
/// exists or du is not finite.
bool solve_for_correction(StaticProblem& problem, std::span<const double> residual, std::span<double> du);

struct NodeDistance {
  double distance = 0;  // [m]
  std::uint32_t node = 0;
};

/// The node with the largest distance between its positions in x and in y, both vectors over all dofs. The
/// rotation of a rigid body counts only through the nodes that the body carries.
NodeDistance furthest_node(const Scene& scene, const Numbering& numbering, std::span<const double> x,
                           std::span<const double> y);
double largest_node_distance(const Scene& scene, const Numbering& numbering, std::span<const double> x,
                             std::span<const double> y);

/// Points at a distance up to this fraction of the gear's size count as the same. Near an equilibrium, the
/// energy grows with the square of the distance, and the relative error of the energy is about the tolerance.
inline const double kSamePlace = std::sqrt(kTolerance);

}  // namespace netloft
