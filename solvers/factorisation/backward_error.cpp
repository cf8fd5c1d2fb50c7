// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/backward_error.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

namespace netloft {

double find_backward_error(const Triplets& a, std::span<const double> x, std::span<const double> b,
                           std::span<double> r, std::span<double> s) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    r[i] = b[i];
    s[i] = std::abs(b[i]);
  }
  const auto take = [&](std::size_t row, std::size_t column, double value) {
    const double product = value * x[column];
    r[row] -= product;
    s[row] += std::abs(product);
  };
  for (std::size_t e = 0; e < a.value.size(); ++e) {
    const auto row = static_cast<std::size_t>(a.row[e] - 1),
               column = static_cast<std::size_t>(a.column[e] - 1);
    take(row, column, a.value[e]);
    if (a.symmetric && row != column) take(column, row, a.value[e]);
  }
  double error = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (!std::isfinite(s[i])) return std::numeric_limits<double>::infinity();
    if (std::abs(r[i]) > error * s[i]) error = std::abs(r[i]) / s[i];
  }
  return error;
}

}  // namespace netloft
