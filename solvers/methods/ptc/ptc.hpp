// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::ptc {

/// Pseudo-transient continuation for r(u) = 0: follows M du/dτ = −r(u) to its end in ever longer steps δ, so
/// that it begins as a descent and ends as Newton's method. M is the linear stiffness, not a mass; τ and δ
/// are therefore pure numbers that do not depend on the size of cells. Each step is solved by Newton's
/// method. If each step were a single linear solve, it would not follow the motion when netting alternates
/// between slack and taut, nor near unstable equilibria. A step leads from u to u′; K = dr/du:
///   M (u′ − u)/δ + r(u′) = 0                                                             (1)
///   (K(v) + M/δ) s = −M (v − u)/δ − r(v),   v ← v + s,   until |s| ≤ `solved` |v − u|    (2)
///   d·r(u′) ≥ 2 d·r(u),   d = u′ − u                                                      (3)
/// (1) is the implicit Euler method, whose first δ is the relaxation time of the linear stiffness; if all
/// forces have a potential, (1) is the proximal point algorithm (R. T. Rockafellar, SIAM J. Control Optim. 14
/// (1976) 877-898). δ is doubled if half of the `corrections` are enough for (2), and halved if all of them
/// are not enough or (3) does not hold. Near a stable equilibrium δ therefore grows without bound, and (2)
/// becomes Newton's method. Sources: C. T. Kelley and D. E. Keyes, SIAM J. Numer. Anal. 35 (1998) 508-523,
/// and E. Hairer and G. Wanner, Solving Ordinary Differential Equations II (1996), IV.8. By (1), d·r(u′) =
/// −d·M d/δ; (3) thus means κ δ ≥ −1/2 for the curvature κ = d·(r(u′) − r(u)) / d·M d. Beyond κ δ = −1, the
/// Euler step ends at the equilibrium that the motion leaves.
struct PseudoTransient {
  struct Parameters {
    double solved = 0;
    std::int64_t corrections = 0;
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::ptc
