// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::newton {

/// Newton's method for r(u) = 0, with two behaviours.
///
/// "classic" is the undamped Newton-Raphson iteration of "Modeling and simulation of bottom trawl gears", eq.
/// 5 and 6:
///   F'(q_i) (q_{i+1} − q_i) = −F(q_i)                                                   (1)
///
/// "globalised" is for forces that have an energy E [J], all or in part: r = g + d, with the gradient g of E
/// and the forces d without an energy (drag). K is the tangent, the derivative of r; K₊ a positive
/// semi-definite part of it, which elements give; M the linear stiffness, which is constant and bounds that
/// part, s·K₊s ≤ s·Ms. μ, σ and θ have no unit.
///   (K + θ (K₊ − K) + μ M) s = −r, with θ in [0, 1] so that the matrix is positive definite (2)
///   m(t) = E(u + t s) + ½ t [d(u) + d(u + t s)]·s, m'(t) ≈ r(u + t s)·s                   (3)
///   t by (L) of line_search.hpp: m does not rise, and is nearly flat                      (4)
///   before (4): t = 1 if s moves no node by more than the length of an element and m(1) ≤ m(0) + b, with
///   b = −c r·s, c the option `uphill`, if m is as low as it has ever been, else b = 0     (5)
///   u ± t v, K v = λ M v with the least λ < 0, t by (D) of descent_search.hpp             (6)
///   t by (S) of line_search.hpp: m is nearly flat and not above m(0) but for rounding     (7)
///   u + t s + ½ t² a, a = −(K + θ (K₊ − K) + μ M)⁻¹ r″(s, s)                              (8)
/// The second term of (3) is the work of d along the path (trapezoidal rule). The slope is that of the work
/// itself, which differs by ¼ t² s·d″ and is exact at t = 0. A dead load d(u) in its place would not turn
/// with the gear.
///
/// See for the rules: (2) in direction.hpp, μ in globalised.cpp, (4), (5) and (8) in
/// merit_steps.hpp, (6) in negative_curvature.hpp, (7) in round_off_steps.hpp.
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
