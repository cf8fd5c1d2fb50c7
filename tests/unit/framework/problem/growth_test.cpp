// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/assembler/pattern.hpp"
#include "solvers/factorisation/factorisation.hpp"

namespace netloft::test {
namespace {

/// A matrix with `below`, `on` and `above` its diagonal.
struct ThreeDiagonals {
  ThreeDiagonals(std::int32_t size, double below, double on, double above) {
    pattern.size = size, pattern.symmetric = false, pattern.column_start = {0};
    for (std::int32_t c = 0; c < size; ++c) {
      for (std::int32_t r = std::max(0, c - 1); r < std::min(size, c + 2); ++r) {
        pattern.row.push_back(r);
        values.push_back(r > c ? below : r == c ? on : above);
      }
      pattern.node.push_back(static_cast<std::uint32_t>(c));
      pattern.column_start.push_back(static_cast<std::int32_t>(pattern.row.size()));
    }
  }
  SparsePattern pattern;
  std::vector<double> values;
};

double growth_of(const ThreeDiagonals& K) {
  const ThreeDiagonals M(K.pattern.size, 0, 1, 0);
  return find_growth(K.pattern, K.values, M.values, make_factorisation).per_power;
}

// Eigenvalues a ± ib of [a b; −b a]: with |λ| = σ and a = −σ cos θ, |(σ − λ)/(σ + λ)|² is (1 + cos θ)/(1 −
// cos θ).
TEST(GrowthOfMatrices, IsThatOfACirculatoryPair) {
  const double cosine = 0.1, sine = std::sqrt(1 - cosine * cosine);
  EXPECT_NEAR(growth_of({2, -sine, -cosine, sine}), std::sqrt(1.1 / 0.9), 1e-2);
  EXPECT_EQ(growth_of({2, -sine, cosine, sine}), 0) << "its symmetric part is positive";
}

// All eigenvalues are 1, and yet what goes down the chain grows until it has left it.
TEST(GrowthOfMatrices, PassesWhereEachFeedsTheNextOne) {
  EXPECT_LE(growth_of({60, -3, 1, 0}), kGrows);
  EXPECT_GT(growth_of({60, -3, -0.1, 0}), kGrows);
}

// λ = 2 − √(3 × 3.1) along (√3.1, −√3).
TEST(GrowthOfMatrices, TellsWhatGrows) {
  const ThreeDiagonals K(2, 3, 2, 3.1), M(2, 0, 1, 0);
  const Growth growth = find_growth(K.pattern, K.values, M.values, make_factorisation);
  ASSERT_TRUE(growth.grows());
  EXPECT_NEAR(growth.mode[0] / growth.mode[1], -std::sqrt(3.1 / 3), 1e-6);
}

}  // namespace
}  // namespace netloft::test
