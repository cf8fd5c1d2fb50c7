// SPDX-License-Identifier: BSD-3-Clause
//
// Sums over vectors of unknowns, for authors of solvers and strategies. Every sum is taken in one fixed
// order, so that results are the same on every machine.
#pragma once
#include <netloft/scatter.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace netloft {

/// Σ aᵢ bᵢ in four partial sums, so that no addition has to wait for the previous one.
inline double dot(std::span<const double> a, std::span<const double> b) {
  double sum[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= a.size(); i += 4)
    for (std::size_t k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
  for (; i < a.size(); ++i) sum[0] += a[i] * b[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// ‖a‖₂
inline double norm(std::span<const double> a) { return std::sqrt(dot(a, a)); }

/// maxᵢ |aᵢ|
inline double largest_of(std::span<const double> a) {
  double largest = 0;
  for (const double v : a) largest = std::max(largest, std::abs(v));
  return largest;
}

/// y ← y + a x
inline void axpy(double a, std::span<const double> x, std::span<double> y) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += a * x[i];
}

/// x ← a x
inline void scale(double a, std::span<double> x) {
  for (double& v : x) v *= a;
}

/// z = x + a y
inline void add_scaled(std::span<const double> x, double a, std::span<const double> y, std::span<double> z) {
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = x[i] + a * y[i];
}

/// Fills x with the numbers of `scattered`, in [−1, 1).
inline void scatter(std::span<double> x) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = scattered(i);
}

}  // namespace netloft
