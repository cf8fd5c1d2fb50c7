// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::ptc {

/// Pseudo-transient continuation for r(u) = 0: follows M du/dτ = −r(u) to its end in ever longer steps δ, so
/// that it begins as a descent and ends as Newton's method. M is the linear stiffness, not a mass: τ and δ
/// are then pure numbers, and mean the same on any size of cell. Each step is solved by Newton's method, and
/// so follows the motion where one linear solve a step would stray: through netting that flickers between
/// slack and taut, and off equilibria that are not stable.
///   M (u′ − u)/δ + r(u′) = 0                                                             (1)
///   (K(v) + M/δ) s = −M (v − u)/δ − r(v),   v ← v + s,   until |s| ≤ `solved` |v − u|    (2)
///   d·r(u′) ≥ 2 d·r(u),   d = u′ − u                                                      (3)
/// (1) is the implicit Euler method, its first δ what the linear stiffness needs to relax; for an energy it
/// is the proximal point algorithm (R. T. Rockafellar, SIAM J. Control Optim. 14 (1976) 877-898). K is dr/du.
/// δ is doubled where half of the `corrections` (2) are enough, and halved where all do not get there or (3)
/// does not hold; so it grows without bound near a stable equilibrium, where (2) is Newton's method. After C.
/// T. Kelley and D. E. Keyes, SIAM J. Numer. Anal. 35 (1998) 508-523, and E. Hairer and G. Wanner, Solving
/// Ordinary Differential Equations II (1996), IV.8. By (1), d·r(u′) = −d·M d/δ: (3) is κ δ ≥ −1/2 for the
/// curvature κ = d·(r(u′) − r(u)) / d·M d. Beyond κ δ = −1, Euler's step leads onto the very equilibrium that
/// the motion leaves.
struct PseudoTransient {
  struct Parameters {
    double solved = 0;
    std::int64_t corrections = 0;
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::ptc
