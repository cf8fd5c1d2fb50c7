// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/static_problem.hpp"

#include <cmath>

namespace netloft {

/// The Newton step that is left at u:
///   K(u) du = −r(u)                                                                     (1)
/// Near an equilibrium du is the way to it but for O(|du|²): an estimate of the error of whatever solver
/// ended at u. K is the exact tangent, of any definiteness. False: no factor or no numbers; du is then
/// meaningless. Booked with `problem`.
bool find_correction(StaticProblem& problem, std::span<const double> u, std::span<const double> residual,
                     std::span<double> du);

/// The same where the problem holds a good factor of K(u) already.
bool solve_for_correction(StaticProblem& problem, std::span<const double> residual, std::span<double> du);

struct NodeDistance {
  double distance = 0;  // [m]
  std::uint32_t node = 0;
};

/// The node whose places in x and y, vectors over all dofs, are furthest from one another. Rotations of rigid
/// bodies are no places: they count through the nodes that the body carries.
NodeDistance furthest_node(const Scene& scene, const Numbering& numbering, std::span<const double> x,
                           std::span<const double> y);
double largest_node_distance(const Scene& scene, const Numbering& numbering, std::span<const double> x,
                             std::span<const double> y);

/// What is one place, of the gear's size: about an equilibrium energies go with the square of a distance, and
/// they are as good as the tolerance.
inline const double kSamePlace = std::sqrt(kTolerance);

}  // namespace netloft
