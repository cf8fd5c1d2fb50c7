// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>

namespace netloft {

/// The entries of a matrix; rows and columns count from one. Of a symmetric one, the lower triangle.
struct Triplets {
  std::span<const int> row, column;
  std::span<const double> value;
  bool symmetric = false;
};

/// Backward error of a solution, after Oettli and Prager (1964).
///   r = b − A x,   s = |A| |x| + |b|                       (1)
///   ω = max |r|ᵢ / sᵢ                                      (2)
/// Sets `r` and `s`, and returns ω: infinite where a number is not finite.
double find_backward_error(const Triplets& a, std::span<const double> x, std::span<const double> b,
                           std::span<double> r, std::span<double> s);

}  // namespace netloft
