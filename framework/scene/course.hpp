// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <vector>

namespace netloft {

/// A path in time: the displacement from the start. With τ = (t − t₀)/H between two knots a time H apart,
///   d = h₀₀ d₀ + h₁₀ H v₀ + h₀₁ d₁ + h₁₁ H v₁,   h the cubic Hermite polynomials in τ         (1)
/// Beyond the ends it continues with the speed of the first or last knot. A speed that is linear between
/// knots is reproduced exactly: its path is a parabola.
struct Course {
  using Point = std::array<double, 3>;
  struct Knot {
    double t;    // [s]
    Point d, v;  // displacement [m], speed [m/s]
  };
  struct Moment {
    Point d{}, v{}, a{};  // [m], [m/s], [m/s²]
  };
  std::vector<Knot> knots;  // increasing in t

  Moment at(double t) const;
};

}  // namespace netloft
