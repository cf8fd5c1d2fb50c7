// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <vector>

namespace netloft {

/// The path of a held node in time, as its displacement d from the start. Between two knots at times t₀ and
/// t₀ + H, with displacements d₀, d₁ and speeds v₀, v₁, and with τ = (t − t₀)/H,
///   d = h₀₀ d₀ + h₁₀ H v₀ + h₀₁ d₁ + h₁₁ H v₁,   h the cubic Hermite polynomials in τ         (1)
/// Beyond the ends, the motion continues at the speed of the first or last knot. (1) is exact if the speed is
/// linear between knots, because the path is then a parabola.
struct Course {
  using Point = std::array<double, 3>;
  struct Knot {
    double t;    // [s]
    Point d, v;  // displacement [m], speed [m/s]
  };
  struct Moment {
    Point d{}, v{}, a{};  // [m], [m/s], [m/s²]
  };
  std::vector<Knot> knots;  // knots in increasing order of t

  Moment at(double t) const;
};

}  // namespace netloft
