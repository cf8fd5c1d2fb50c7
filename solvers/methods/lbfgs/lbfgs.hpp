// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::lbfgs {

/// Limited-memory BFGS: minimises an energy E of the unknowns u, whose gradient is r. The curvature is
/// estimated from the last steps instead of a tangent.
///   p = −H_k r_k,   u_{k+1} = u_k + t p                                                  (1)
///   H_k: H⁰_k after the BFGS updates by the last pairs s_i = u_{i+1} − u_i, y_i = r_{i+1} − r_i   (2)
///   H⁰_k = γ B,   γ = (s·y)/(y·B y) of the last pair                                      (3)
///   a pair with s·y ≤ ε ‖s‖ ‖y‖ is left out                                              (4)
/// B, the preconditioner, is the inverse of the linear stiffness, factorised once, or of the diagonal of its
/// row sums, or the unit matrix. wolfe_search.hpp finds t; if it fails, the memory of pairs is cleared; if it
/// fails again, no step lowers E. (1), (2): J. Nocedal, "Updating quasi-Newton matrices with limited
/// storage", Math. Comp. 35 (1980) 773-782; J. Nocedal and S. J. Wright, "Numerical Optimization", 2nd ed.,
/// Springer 2006, alg. 7.4 and 7.5. (3): their eq. 7.20 in the metric of B; on netting, it takes a third
/// fewer steps than γ = 1. (4): cautious update, after D.-H. Li and M. Fukushima, SIAM J. Optim. 11 (2001)
/// 1054-1064.
///
/// A step costs little more than an evaluation and a solve with the factor. Convergence takes hundreds of
/// steps; the option `steps` says how many of them count as one iteration of the host.
struct Lbfgs {
  struct Parameters {
    std::int64_t memory = 0, preconditioner = 0, steps = 0;
    double decrease = 0, curvature = 0;
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::lbfgs
