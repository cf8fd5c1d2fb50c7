// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::newton {

/// Newton's method for r(u) = 0, in two behaviours.
///
/// "classic", the Newton-Raphson iteration of the trawl-gear paper, eq. 5 and 6, undamped, as published:
///   F'(q_i) (q_{i+1} − q_i) = −F(q_i)                                                   (1)
///
/// "globalised", for problems with an energy E whose gradient is r. M is the linear stiffness, which bounds
/// the convex part K₊ of the tangent K:
///   (K + μ M) s = −r   if that matrix is positive definite, else (K₊ + μ₊ M) s = −r      (2)
///   E(u + t s) ≤ E(u) + c t r·s,  t = 1, then smaller by a parabola through E, E', E(t)  (3)
///   ρ = (E(u) − E(u + s)) / −(r·s + ½ s·(K + μM) s)                                     (4)
/// μ falls when the model of (4) is good and rises when it is not. With μ₊ = 1 the step cannot raise a convex
/// energy (Levenberg 1944, in the metric of the linear stiffness); with μ = 0 it is Newton's.
/// Near the end E has no digits left for (3); then a step counts that does not raise ‖r‖.
struct Newton {
  struct Parameters {
    std::int64_t method = 0;
    double damping = 0, decrease = 0, shortest_step = 0;
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::newton
