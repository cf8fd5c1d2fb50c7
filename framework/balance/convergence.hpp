// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft {

enum class Convergence { none, at_round_off, within_tolerance };

/// What convergence is judged by: norms of a node's force, the largest of all nodes [N].
struct Imbalance {
  double residual = 0;      // r
  double load = 0;          // F, of forces that do not depend on the state and of reactions
  double rounding = 0;      // b, what rounding of the positions can make of the residual at most
  bool is_driven = true;    // some force acts that is not the elements' own: weight, drag, pressure
  bool is_in_time = false;  // a step in time, whose inertia rounds, too
};

/// The tolerance (1) of an equilibrium, where nobody says another.
inline constexpr double kTolerance = 1e-10;

/// Whether forces balance, to a tolerance ε of the load: (1) to (4), and (5) below where a solver finds no
/// way on.
///   within tolerance:  r ≤ ε F                                                            (1)
///   at round-off:      r ≤ min(b, β F)                                                    (2)
/// At rest neither counts unless
///   b ≤ β F,   β = kMatters:                                                              (3)
/// where stiffness times the rounding of positions is not small against the load, tensions are not known, and
/// a small residual is luck. β is the least imbalance that matters (imbalance.hpp). Rounding in a step in
/// time passes with the step, so that (3) is not asked of it.
/// A gear that nothing loads but its own rounding rests where
///   F ≤ b and r ≤ b, nothing driving it                                                   (4)
/// An infinite load excuses nothing.
Convergence convergence_of(const Imbalance& i, double tolerance);

/// At round-off, what still falls by half from one point to the next is not all rounding: that of stiff parts
/// hides how far soft ones are from balance, and an iteration had better go on.
bool may_stop(Convergence c, double residual, double residual_before);

/// Twines that flicker between slack and taut can leave a residual that no step reduces. Where the solver has
/// given up, the tangent of an energy is positive definite and a full step of Newton's method raises the
/// residual (`no_step_helps` in assessment.cpp asks that), it is as good as round-off if (3) holds, r ≤ β F,
/// and the energy g that a Newton step would gain is next to nothing:
///   g ≤ ε₀ F L,   ε₀ = kTolerance                                                         (5)
/// with L the size of the gear. By g ≈ ½ r δ the place is off by δ ≈ 2e-7 L where r = β F; a smaller r allows
/// more, with a stiffness of F/L up to √(2 ε₀) L.
bool has_nothing_to_gain(const Imbalance& i, double gain, double size);

}  // namespace netloft
