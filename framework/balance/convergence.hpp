// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft {

enum class Convergence { none, at_round_off, within_tolerance };

/// The quantities that decide on convergence: norms of nodal forces, each the largest of all nodes [N].
struct Imbalance {
  double residual = 0;    // r, the largest nodal residual
  double load = 0;        // F, the largest of all dead loads and reactions
  double rounding = 0;    // b, upper bound of the residual that rounding of the positions can cause
  bool is_driven = true;  // whether an external force acts, such as weight, drag or pressure
  // Whether this is a step in time, in which inertia forces have rounding errors, too.
  bool is_in_time = false;
};

/// Default tolerance ε of (1).
inline constexpr double kTolerance = 1e-10;

/// Decides whether forces balance to a tolerance ε of the load, with r, F and b of Imbalance:
///   within tolerance:  r ≤ ε F                                                            (1)
///   at round-off:      r ≤ min(b, β F)                                                    (2)
/// At rest, (1) and (2) also require
///   b ≤ β F,   β = kMatters                                                               (3)
/// If (3) is violated, rounding of the positions changes tensions by as much as the load, and a small
/// residual is accidental. β is the least imbalance that matters (imbalance.hpp). A step in time does not
/// require (3), because rounding errors of one step do not affect the next.
/// A gear without external forces, loaded by nothing but rounding errors, is at rest if
///   F ≤ b and r ≤ b                                                                       (4)
/// A gear with an infinite load has not converged.
Convergence convergence_of(const Imbalance& i, double tolerance);

/// Whether an iteration may stop. Within the tolerance, it may. At round-off, it continues as long as each
/// point has less than half the residual of the point before. Rounding errors do not fall so steadily: such a
/// residual is a true imbalance of soft parts, hidden below the rounding errors of stiff parts.
bool may_stop(Convergence c, double residual, double residual_before);

/// Whether to accept a residual that no step reduces because twines alternate between slack and taut. If the
/// solver has given up, the point then counts as converged to round-off, provided that the tangent is
/// positive definite and that a full Newton step raises the residual (`no_step_helps` in assessment.cpp). The
/// function requires (3), r ≤ β F and (5), where g is the energy that a Newton step would gain and L the size
/// of the gear:
///   g ≤ ε₀ F L,   ε₀ = kTolerance                                                         (5)
/// With g ≈ ½ r δ, the error of the positions is δ ≈ 2e-7 L at r = β F. A smaller r allows a larger error, up
/// to √(2 ε₀) L at a stiffness of F/L.
bool has_nothing_to_gain(const Imbalance& i, double gain, double size);

}  // namespace netloft
