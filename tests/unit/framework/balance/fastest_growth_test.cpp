// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>

#include "framework/judging/growth.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/unit/solvers/known_answers.hpp"

namespace netloft::test {
namespace {

constexpr int kSize = 8;
using Matrix = Eigen::Matrix<double, kSize, kSize>;

SparsePattern full_pattern() {
  SparsePattern p;
  p.size = kSize, p.symmetric = false, p.column_start = {0};
  for (int c = 0; c < kSize; ++c) {
    for (int r = 0; r < kSize; ++r) p.row.push_back(r);
    p.node.push_back(static_cast<std::uint32_t>(c));
    p.column_start.push_back(kSize * (c + 1));
  }
  return p;
}

Matrix random(unsigned seed) {
  const auto numbers = random_numbers(kSize * kSize, seed);
  return Eigen::Map<const Matrix>(numbers.data());
}

/// The motion M ÿ + C ẏ + (K₊ + N) y = 0. K₊ is a high stiffness along half of the directions. The motion is
/// driven by N, a millionth of K₊, and by negative damping in C.
struct Driven {
  Matrix M, C, convex, N;

  Driven(unsigned seed, double lack) {
    M = Matrix::Zero(), C = 0.1 * random(3 * seed), convex = 1e3 * random(3 * seed + 1);
    N = 10 * random(3 * seed + 2);
    for (int i = 0; i < kSize; ++i) M(i, i) = std::pow(10, 2.0 * i / kSize - 2);
    convex.rightCols<kSize / 2>().setZero();
    C = (C * C.transpose() - lack * Matrix::Identity()).eval(), convex = (convex * convex.transpose()).eval();
  }
  LinearMotion motion() const {
    const auto values = [](const Matrix& A) { return std::vector<double>(A.data(), A.data() + A.size()); };
    return {.K = values(convex + N), .C = values(C), .M = values(M), .convex = values(convex)};
  }
  Eigen::VectorXcd rates() const {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * kSize, 2 * kSize);
    A.topRightCorner<kSize, kSize>().setIdentity();
    const Eigen::VectorXd lightness = M.diagonal().cwiseInverse();
    A.bottomLeftCorner<kSize, kSize>() = -(lightness.asDiagonal() * (convex + N));
    A.bottomRightCorner<kSize, kSize>() = -(lightness.asDiagonal() * C);
    return A.eigenvalues();
  }
};

// The bound is compared with all eigenvalues whose growth rate is at least a hundredth of |s|.
TEST(FastestGrowth, IsNotExceededByWhatGrows) {
  const SparsePattern p = full_pattern();
  int grow = 0;
  double fastest = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Driven driven(seed, seed % 2 == 0 ? 0.05 : 0);
    const double estimate = fastest_growth(p, driven.motion(), 0.01);
    for (const auto& s : driven.rates()) {
      fastest = std::max(fastest, std::abs(s));
      if (s.real() < 0.01 * std::abs(s)) continue;
      EXPECT_LE(std::abs(s), estimate) << seed;
      ++grow;
    }
  }
  EXPECT_GT(grow, 20);
  EXPECT_GT(fastest, 1e4) << "what is stiff is faster";
}

// Three values of σ suffice, with one factorisation each: 10/s, 0.1/s and 1e-3/s. If σ were bounded by
// stiffness and mass alone, it would range up to 1e7/s.
TEST(FastestGrowth, SparesWhatIsOnlyStiff) {
  Driven driven(1, 0);
  driven.M.setIdentity(), driven.C.setIdentity(), driven.convex = 1e12 * Matrix::Identity();
  driven.N = Matrix::Zero(), driven.N(0, 1) = 0.3, driven.N(1, 0) = -0.3;
  Statistics cost;
  Factors factors(make_factorisation, cost);
  EXPECT_EQ(find_growth(full_pattern(), driven.motion(), factors).verdict, GrowthVerdict::none);
  EXPECT_EQ(cost.factorisations, 3);
}

// The eigenvalues s = 50 ± 999i follow from C alone, which neither K₊ nor N contains.
TEST(FastestGrowth, SeesWhatNegativeDampingDrives) {
  Driven driven(1, 0);
  driven.M.setIdentity(), driven.C.setIdentity(), driven.convex = 1e6 * Matrix::Identity();
  driven.N.setZero(), driven.C(2, 2) = -100;
  Statistics cost;
  Factors factors(make_factorisation, cost);
  const Growth g = find_growth(full_pattern(), driven.motion(), factors);
  ASSERT_TRUE(g.grows());
  EXPECT_NEAR(g.rate, 50, 1e-6);
  EXPECT_NEAR(g.frequency, std::sqrt(1e6 - 2500), 1e-6);
}

}  // namespace
}  // namespace netloft::test
