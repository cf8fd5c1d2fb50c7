// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/integrator.hpp>

namespace netloft::newmark {

/// The single-step scheme of Newmark (J. Eng. Mech. Div. ASCE 85, 1959), as in the trawl-gear paper, eq.
/// 7–12:
///   F(t, q, q̇, q̈) = 0                                              paper (7)          (1)
///   qₙ₊₁ = qₙ + h q̇ₙ + h²/2 [(1 − 2β) q̈ₙ + 2β q̈ₙ₊₁]                      (8)          (2)
///   q̇ₙ₊₁ = q̇ₙ + h [(1 − γ) q̈ₙ + γ q̈ₙ₊₁]                                  (9)          (3)
///   β = (1 − χ)²/4,  γ = (1 − 2χ)/2                                    (11), (12)     (4)
///
/// The corrector "fixed-point" is that of the paper, with χ = −0.3: it begins with q̈ₙ₊₁ = q̈ₙ and repeats
/// (2), (3) and q̈ₙ₊₁ from (1) until β h² q̈ₙ₊₁ settles. It solves no linear system. For a linear spring of
/// frequency ω, every pass multiplies an error of q̈ₙ₊₁ by −β h² ω², so that the iteration converges if
///   h < 1/(√β ω_max)                                                                    (5)
/// The corrector "solve", with χ = 0, solves (1) for qₙ₊₁ with q̈ₙ₊₁ from (2). With ũ, the terms of (2) at
/// tₙ:
///   q̈ = (q − ũ)/(β h²),  q̇ = q̇ₙ + h (1 − γ) q̈ₙ + γ (q − ũ)/(β h)                        (6)
/// It is stable for any h if χ ≤ 0, and of first order if χ < 0, of second order if χ = 0.
///
/// The error of one step follows from the Taylor series of (2) and (3); the error of (3) acts during the
/// whole motion:
///   h² (|β − 1/6| + |γ − 1/2|) (q̈ₙ₊₁ − q̈ₙ)                                              (7)
struct Newmark {
  enum Corrector { kSolve, kFixedPoint };
  struct Parameters {
    std::int64_t corrector = kSolve, corrections = 0;
    double chi = 0, settled = 0;
  };
  static Step step(const Parameters& p, Motion& m);
  static double order(const Parameters&) { return 3; }
  static double stable_step(const Parameters& p, double omega);
};

}  // namespace netloft::newmark
