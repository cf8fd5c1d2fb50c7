// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <span>

namespace netloft {

/// Sum of a_i b_i. Four partial sums, so that no addition waits for the last; the order is the same in every
/// build, and so are the bits.
inline double dot(std::span<const double> a, std::span<const double> b) {
  double sum[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= a.size(); i += 4)
    for (std::size_t k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
  for (; i < a.size(); ++i) sum[0] += a[i] * b[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

inline double norm(std::span<const double> a) { return std::sqrt(dot(a, a)); }

/// y += a x
inline void axpy(double a, std::span<const double> x, std::span<double> y) {
  for (std::size_t i = 0; i < x.size(); ++i) y[i] += a * x[i];
}

}  // namespace netloft
