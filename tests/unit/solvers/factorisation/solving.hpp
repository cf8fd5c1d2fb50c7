// SPDX-License-Identifier: BSD-3-Clause
//
// Helpers for tests of factorisations: a right-hand side, and the error of its solution.
#pragma once
#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>

#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {

inline constexpr double kRoundOff = 1e-14;  // backward error of a stable factorisation: some tens of eps

inline constexpr double kMostOf32Bits = 2147483647;  // largest index of 32 bits

/// Memory that malloc has allocated; 0 in builds with a sanitizer, whose malloc does not report it.
inline double allocated_bytes() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

inline std::vector<double> made_up_vector(std::int32_t size) {
  std::vector<double> b(size);
  for (std::int32_t i = 0; i < size; ++i) b[i] = std::cos(0.3 * i);
  return b;
}

/// Solves with new values in the pattern that was analysed last.
inline std::vector<double> solve_again(Factorisation& factorisation, const TestMatrix& matrix) {
  EXPECT_EQ(factorisation.factorise(matrix.value).status, FactorStatus::ok);
  const std::vector<double> b = made_up_vector(matrix.pattern.size);
  std::vector<double> x(b.size());
  factorisation.solve(b, x);
  return x;
}

inline std::vector<double> solve(Factorisation& factorisation, const TestMatrix& matrix) {
  factorisation.analyse(matrix.pattern);
  return solve_again(factorisation, matrix);
}

/// Backward error of solve_again(), and of a solve with a new analysis.
inline double error_of_solving_again(Factorisation& factorisation, const TestMatrix& matrix) {
  return matrix.backward_error(solve_again(factorisation, matrix), made_up_vector(matrix.pattern.size));
}
inline double error_of_solving(Factorisation& factorisation, const TestMatrix& matrix) {
  return matrix.backward_error(solve(factorisation, matrix), made_up_vector(matrix.pattern.size));
}

}  // namespace netloft
