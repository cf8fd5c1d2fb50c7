// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::ptc {

/// Pseudo-transient continuation for r(u) = 0: follows M du/dτ = −r(u) to its end in ever longer steps δ, so
/// that it begins as a descent and ends as Newton's method.
///   (K + M/δ) s = −r(u),   u ← u + s                                                    (1)
///   δ_k = δ_{k−1} ‖r_{k−1}‖/‖r_k‖                                                         (2)
/// (1) is a step of the linearly implicit Euler method; (2) is switched evolution relaxation: C. T. Kelley
/// and D. E. Keyes, "Convergence analysis of pseudo-transient continuation", SIAM J. Numer. Anal. 35 (1998)
/// 508-523; (2) after W. A. Mulder and B. van Leer, J. Comput. Phys. 59 (1985) 232-246. K is dr/du. M is the
/// linear stiffness, not a mass: τ and δ are then pure numbers, and mean the same on any size of cell.
///
/// Where it deviates:
/// - where K + M/δ is symmetric and not positive definite, the convex part K₊ of K takes the place of K;
/// - a step is taken back, and δ quartered, that moves a node farther than `reach` largest elements, leads to
///   where there are no forces or, where r has an energy, raises both energy and ‖r‖. Without an energy, ‖r‖
///   may rise as it likes: on stiff ropes it must, and taking such steps back never arrived;
/// - one step changes δ by no more than `growth` and no less than `shrink`: where netting falls into shape,
/// ‖r‖
///   grows for a while, which says little of how long the next step may be.
///
/// That is the method "linearly-implicit". The method "implicit" solves each step for what it is, by
/// Newton's method, and so follows the motion where one linear solve a step strays: through netting that
/// flickers between slack and taut, and off equilibria that are not stable.
///   M (u′ − u)/δ + r(u′) = 0                                                             (3)
///   (K(v) + M/δ) s = −M (v − u)/δ − r(v),   v ← v + s,   until |s| ≤ `solved` |v − u|    (4)
///   d·r(u′) ≥ 2 d·r(u),   d = u′ − u                                                      (5)
/// (3) is the implicit Euler method, its first δ what the linear stiffness needs to relax; for an energy it
/// is the proximal point algorithm (R. T. Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898). δ is
/// doubled where half of the `corrections` (4) are enough, and halved where all do not get there or (5) does
/// not hold; so it grows without bound near a stable equilibrium, where (4) is Newton's method. After E.
/// Hairer and G. Wanner, Solving Ordinary Differential Equations II (1996), IV.8. By (3), d·r(u′) = −d·M d/δ:
/// (5) is κ δ ≥ −1/2 for the curvature κ = d·(r(u′) − r(u)) / d·M d. Beyond κ δ = −1, Euler's step leads onto
/// the very equilibrium that the motion leaves.
struct PseudoTransient {
  struct Parameters {
    std::int64_t method = 0;
    double step = 0, growth = 0, shrink = 0, reach = 0, solved = 0;
    std::int64_t corrections = 0;
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::ptc
