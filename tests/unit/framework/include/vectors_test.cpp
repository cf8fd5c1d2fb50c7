// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/vectors.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace netloft {
namespace {

using Vector = std::vector<double>;

// 1·5 + 2·4 + 3·3 + 4·2 + 5·1 = 35: five products, one more than there are partial sums.
TEST(Vectors, ADotProductCountsEveryEntry) {
  EXPECT_EQ(dot(Vector{1, 2, 3, 4, 5}, Vector{5, 4, 3, 2, 1}), 35);
  EXPECT_EQ(dot(Vector{}, Vector{}), 0);
}

TEST(Vectors, TheNormIsThatOfPythagoras) { EXPECT_EQ(norm(Vector{2, 3, 6}), 7); }

TEST(Vectors, AxpyAddsToWhatIsThere) {
  Vector y{1, 2};
  axpy(-2, Vector{3, 4}, y);
  EXPECT_EQ(y, (Vector{-5, -6}));
}

TEST(Vectors, AScaledSumLeavesItsTermsAlone) {
  const Vector x{1, 2}, y{3, 4};
  Vector z(2);
  add_scaled(x, 2, y, z);
  EXPECT_EQ(z, (Vector{7, 10}));
}

// Multiples of an irrational number are distributed evenly (Weyl). Their mean therefore tends to 0 as 1/n
// (the golden ratio's discrepancy is below 1/√5 log n/n), and the mean of their squares tends to 1/3.
TEST(Vectors, AScatteredVectorIsSpreadEvenly) {
  Vector x(1000);
  scatter(x);
  double sum = 0;
  for (const double v : x) {
    sum += v;
    EXPECT_LT(std::abs(v), 1);
  }
  EXPECT_LT(std::abs(sum) / 1000, 5e-3);
  EXPECT_NEAR(dot(x, x) / 1000, 1.0 / 3, 5e-3);
}

}  // namespace
}  // namespace netloft
