// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/vectors.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace netloft::tension::cone {

/// Points x = (x₀, x̄) of R⁴, where x̄ are the last three numbers. The cone K contains those with x₀ ≥ ‖x̄‖.
/// Notation and formulas after L. Vandenberghe, "The CVXOPT linear and quadratic cone program solvers"
/// (2010), sections 4 and 5.
using Point = std::array<double, 4>;

/// Returns J x = (x₀, −x̄), the mirror image of x.
inline Point mirrored(const Point& x) { return {x[0], -x[1], -x[2], -x[3]}; }

inline double length(const Point& x) { return std::sqrt(x[1] * x[1] + x[2] * x[2] + x[3] * x[3]); }

/// Returns x₀² − ‖x̄‖², positive inside K, as a product that keeps its digits near the boundary of K.
inline double determinant(const Point& x) { return (x[0] - length(x)) * (x[0] + length(x)); }

/// Returns a ∘ b = (a·b, a₀ b̄ + b₀ ā).
inline Point product(const Point& a, const Point& b) {
  return {dot(a, b), a[0] * b[1] + b[0] * a[1], a[0] * b[2] + b[0] * a[2], a[0] * b[3] + b[0] * a[3]};
}

/// Solves v ∘ x = r for x.
inline Point quotient(const Point& r, const Point& v) {
  Point x;
  x[0] = dot(mirrored(v), r) / determinant(v);
  for (std::size_t i = 1; i < 4; ++i) x[i] = (r[i] - x[0] * v[i]) / v[0];
  return x;
}

/// The largest step a for which x + a d is in K, or infinity; x must be inside K.
inline double step_to_boundary(const Point& x, const Point& d) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double a = dot(mirrored(d), d), b = dot(mirrored(x), d), c = determinant(x);
  double least = d[0] < 0 ? -x[0] / d[0] : kNever;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return least;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  for (const double root : {q / a, c / q})
    if (root > 0) least = std::min(least, root);
  return least;
}

/// The scaling W of Nesterov and Todd for z and y inside K, defined by W z = W⁻¹ y. v and p are vectors, β is
/// a number, J x = (x₀, −x̄):
///   W = β (2 v vᵀ − J),  W² = β² (2 p pᵀ − J)                                             (1)
class Scaling {
 public:
  Scaling(const Point& z, const Point& y) {
    const double of_z = std::sqrt(determinant(z)), of_y = std::sqrt(determinant(y));
    Point one_z, one_y;
    for (std::size_t i = 0; i < 4; ++i) {
      one_z[i] = z[i] / of_z;
      one_y[i] = y[i] / of_y;
    }
    const double gamma = std::sqrt((1 + dot(one_z, one_y)) / 2);
    one_z = mirrored(one_z);
    for (std::size_t i = 0; i < 4; ++i) p_[i] = (one_y[i] + one_z[i]) / (2 * gamma);
    const double scale = 1 / std::sqrt(2 * (p_[0] + 1));
    for (std::size_t i = 0; i < 4; ++i) v_[i] = scale * (p_[i] + (i == 0 ? 1 : 0));
    beta_ = std::sqrt(of_y / of_z);
  }

  /// Returns W x.
  Point scaled(const Point& x) const {
    const double along = 2 * dot(v_, x);
    const Point Jx = mirrored(x);
    Point y;
    for (std::size_t i = 0; i < 4; ++i) y[i] = beta_ * (along * v_[i] - Jx[i]);
    return y;
  }
  /// Returns W⁻¹ x.
  Point unscaled(const Point& x) const {
    const double along = 2 * dot(mirrored(v_), x);
    const Point Jv = mirrored(v_), Jx = mirrored(x);
    Point y;
    for (std::size_t i = 0; i < 4; ++i) y[i] = (along * Jv[i] - Jx[i]) / beta_;
    return y;
  }
  /// Returns an entry of W².
  double squared(std::size_t i, std::size_t j) const {
    const double J = i != j ? 0 : i == 0 ? 1 : -1;
    return beta_ * beta_ * (2 * p_[i] * p_[j] - J);
  }

 private:
  double beta_ = 1;
  Point p_{}, v_{};
};

}  // namespace netloft::tension::cone
