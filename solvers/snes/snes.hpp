// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::snes {

/// Newton's methods of PETSc's SNES (Balay et al., PETSc/TAO Users Manual 3.18, chapter "SNES: Nonlinear
/// solvers") on our residuals and factorisations. K is the exact tangent, M the linear stiffness.
///   (K(u) + μ M) s = −r(u),   u ← u + λ s                                                (1)
/// Strategy "none": λ = 1. "linesearch" (newtonls, bt): λ by a cubic until ½‖r‖² falls enough. "trust-region"
/// (newtontr): s is limited to a radius that is adapted to the accuracy with which (1) predicts ‖r‖.
struct Snes {
  struct Parameters {
    std::int64_t strategy = 0;
    double damping = 0;  // μ
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::snes
