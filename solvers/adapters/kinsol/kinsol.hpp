// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::kinsol {

/// Newton's method of SUNDIALS' KINSOL 6 (Hindmarsh et al. 2005, ACM TOMS 31(3), p. 363; users' guide,
/// chapter "Mathematical considerations") with the residuals r and factorisations of the host. K is the exact
/// tangent, M the linear stiffness.
///   (K(u) + μ M) s = −r(u)                                                              (1)
///   u ← u + λ s                                                                         (2)
/// Strategy "none": λ = 1. "linesearch": λ, within what `longest_step` allows, meets Goldstein's conditions
///   ½‖r(u + λ s)‖² ≤ ½‖r(u)‖² + 1e-4 λ r·Ks,   and ≥ it with 0.9 in place of 1e-4         (3)
/// If μ = 0 and K is singular, as for a straight slack rope, the solver fails at the first step.
struct Kinsol {
  struct Parameters {
    std::int64_t strategy = 0;
    double damping = 0;        // factor μ of (1)
    double longest_step = 0;   // longest step (root mean square), in lengths of the largest element
    double shortest_step = 0;  // shortest step: its largest component relative to the unknown
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::kinsol
