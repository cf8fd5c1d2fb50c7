// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::newton {

/// Newton's method for r(u) = 0, with two behaviours.
///
/// "classic" is the undamped Newton-Raphson iteration of "Modeling and simulation of bottom trawl gears", eq.
/// 5 and 6:
///   F'(q_i) (q_{i+1} − q_i) = −F(q_i)                                                   (1)
/// "globalised" assumes that some or all forces have a potential, the energy E [J]: r = g + d, with the
/// gradient g of E and the forces d without a potential (drag). K is the tangent, the derivative of r; K₊ is
/// a positive semi-definite part of K, which elements give; M is the linear stiffness, which is constant and
/// bounds K₊: s·K₊s ≤ s·Ms. μ, σ and θ have no unit.
///   (K + θ (K₊ − K) + μ M) s = −r, with θ in [0, 1] so that the matrix is positive definite (2)
///   m(t) = E(u + t s) + ½ t [d(u) + d(u + t s)]·s, m'(t) ≈ r(u + t s)·s                   (3)
///   t by (L) of line_search.hpp: m does not rise, and is nearly flat                      (4)
///   before (4): t = 1 if s moves no node by more than the length of an element and m(1) ≤ m(0) + b, with
///   b = −c r·s, c the option `uphill`, if m is as low as it has ever been, else b = 0     (5)
///   u ± t v, K v = λ M v with the least λ < 0, t by (D) of descent_search.hpp             (6)
///   t by (S) of line_search.hpp: m is nearly flat, and above m(0) by rounding at most     (7)
///   u + t s + ½ t² a, a = −(K + θ (K₊ − K) + μ M)⁻¹ r″(s, s)                              (8)
/// m is the merit. Its second term is the work of d along the path, by the trapezoidal rule; if d(u) were
/// taken as constant, drag would not turn with the gear. m' is the slope with the exact work instead, which
/// differs by ¼ t² s·d″ and is equal at t = 0. These files explain when each rule is used: direction.hpp (2),
/// globalised.cpp μ, merit_steps.hpp (4), (5), (8), negative_curvature.hpp (6), round_off_steps.hpp (7).
struct Newton {
  struct Parameters {
    std::int64_t method = 0;
    double damping = 0, least_damping = 0, most_damping = 0, factor = 0;
    double flatness = 0, uphill = 0, margin = 0;
    std::int64_t refinements = 0;
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::newton
