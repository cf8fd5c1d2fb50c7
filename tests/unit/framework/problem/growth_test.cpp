// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/growth.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

#include "framework/assembler/pattern.hpp"
#include "solvers/factorisation/factorisation.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

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

double growth_of(const ThreeDiagonals& K, const ThreeDiagonals& M) {
  return find_growth(K.pattern, K.values, M.values, make_factorisation).per_power;
}

double growth_of(const ThreeDiagonals& K) { return growth_of(K, {K.pattern.size, 0, 1, 0}); }

// Eigenvalues a ± ib of [a b; −b a]: with |λ| = σ and a = −σ cos θ, |(σ − λ)/(σ + λ)|² is (1 + cos θ)/(1 −
// cos θ).
TEST(GrowthOfMatrices, IsThatOfACirculatoryPair) {
  const double cosine = 0.1, sine = std::sqrt(1 - cosine * cosine);
  EXPECT_NEAR(growth_of({2, -sine, -cosine, sine}), std::sqrt(1.1 / 0.9), 1e-2);
  EXPECT_EQ(growth_of({2, -sine, cosine, sine}), 0) << "its symmetric part is positive";
}

// All eigenvalues are 1, and yet what goes down the chain grows until it has left it, by 3^19. (Of a chain of
// 60 the growth of 3^59 is beyond what double precision tells from an instability.)
TEST(GrowthOfMatrices, PassesWhereEachFeedsTheNextOne) {
  EXPECT_LE(growth_of({20, -3, 1, 0}), kGrows);
  EXPECT_GT(growth_of({20, -3, -0.1, 0}), kGrows);
}

/// A full matrix of numbers in [-1, 1] with `shift` on its diagonal.
ThreeDiagonals random_matrix(int size, double shift, unsigned seed) {
  ThreeDiagonals K(size, 0, 0, 0);
  K.pattern.row.clear(), K.pattern.column_start = {0},
                         K.values = random_numbers(static_cast<std::size_t>(size * size), seed);
  for (int c = 0; c < size; ++c) {
    for (int r = 0; r < size; ++r) K.pattern.row.push_back(r);
    K.pattern.column_start.push_back(static_cast<std::int32_t>(K.pattern.row.size()));
    K.values[static_cast<std::size_t>(c * size + c)] += shift;
  }
  return K;
}

// Against all eigenvalues of the full problem, over six decades of time scales in one matrix.
TEST(GrowthOfMatrices, IsFoundWhereverSomeEigenvalueGrows) {
  constexpr int kSize = 80;
  int grow = 0, decay = 0, marginal = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    ThreeDiagonals K = random_matrix(kSize, 2 + 0.1 * seed, seed), M = K;
    std::fill(M.values.begin(), M.values.end(), 0.0);
    for (int i = 0; i < kSize; ++i) {
      const double scale = std::pow(10, -6.0 * i / kSize);
      M.values[static_cast<std::size_t>(i * kSize + i)] = 1;
      for (int c = 0; c < kSize; ++c) K.values[static_cast<std::size_t>(c * kSize + i)] *= scale;
    }
    const Eigen::MatrixXd full = Eigen::Map<const Eigen::MatrixXd>(K.values.data(), kSize, kSize);
    double c = -1;  // (5) of what grows most
    for (const auto& lambda : full.eigenvalues()) c = std::max(c, -lambda.real() / std::abs(lambda));
    const Growth growth = find_growth(K.pattern, K.values, M.values, make_factorisation);
    if (c > 0.011) {
      EXPECT_TRUE(growth.grows()) << seed << ": " << c;
    } else if (c <= 0) {
      EXPECT_EQ(growth.verdict, GrowthVerdict::none) << seed << ": " << c;
    }
    ++(c > 0.011 ? grow : c <= 0 ? decay : marginal);
  }
  EXPECT_GT(grow, 10);
  EXPECT_GT(decay, 10);
}

// λ = -0.005 ± i and 0.005 ± i: in the band (5), and where it decays.
TEST(GrowthOfMatrices, IsMarginalWhereAPairHardlyGrows) {
  const ThreeDiagonals M(2, 0, 1, 0), grows(2, -1, -0.005, 1), decays(2, -1, 0.005, 1);
  EXPECT_EQ(find_growth(grows.pattern, grows.values, M.values, make_factorisation).verdict,
            GrowthVerdict::marginal);
  EXPECT_EQ(find_growth(decays.pattern, decays.values, M.values, make_factorisation).verdict,
            GrowthVerdict::none);
}

// λ = -1e-3 of a stiffness that is known to 1e-2, or exactly.
TEST(GrowthOfMatrices, IsMarginalWhereTheStiffnessIsNotKnownThatWell) {
  ThreeDiagonals K(2, 0, 1, 0);
  K.values.front() = -1e-3;
  const ThreeDiagonals M(2, 0, 1, 0);
  const auto verdict = [&](double doubt) {
    return find_growth(K.pattern, K.values, M.values, make_factorisation, doubt).verdict;
  };
  EXPECT_EQ(verdict(0), GrowthVerdict::grows);
  EXPECT_EQ(verdict(1e-2), GrowthVerdict::marginal);
}

// 2 factorisations by (7), one for each of six σ from 1 to 1e-10 and 24 solutions with it.
TEST(GrowthOfMatrices, CountsWhatItTakes) {
  const ThreeDiagonals K(200, -3, 2, 3.5), M(200, 0, 1, 0);
  ThreeDiagonals indefinite = K;
  indefinite.values.front() = -1e-20;
  const Growth growth = find_growth(indefinite.pattern, indefinite.values, M.values, make_factorisation);
  ASSERT_EQ(growth.verdict, GrowthVerdict::none);
  EXPECT_EQ(growth.cost.factorisations, 2 + 6);
  EXPECT_EQ(growth.cost.solves, 6 * 24);
}

TEST(GrowthOfMatrices, HasTheSameBitsEachTime) {
  const ThreeDiagonals K = random_matrix(50, 3, 7);
  ThreeDiagonals unit = random_matrix(50, 3, 7);
  std::fill(unit.values.begin(), unit.values.end(), 0.0);
  for (std::size_t i = 0; i < 50; ++i) unit.values[51 * i] = 1;
  const Growth a = find_growth(K.pattern, K.values, unit.values, make_factorisation),
               b = find_growth(K.pattern, K.values, unit.values, make_factorisation);
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.rate, b.rate);
  EXPECT_EQ(a.mode, b.mode);
}

// λ = 2 − √(3 × 3.1) along (√3.1, −√3).
TEST(GrowthOfMatrices, TellsWhatGrows) {
  const ThreeDiagonals K(2, 3, 2, 3.1), M(2, 0, 1, 0);
  const Growth growth = find_growth(K.pattern, K.values, M.values, make_factorisation);
  ASSERT_TRUE(growth.grows());
  EXPECT_NEAR(growth.mode[0] / growth.mode[1], -std::sqrt(3.1 / 3), 1e-6);
}

// λ = −1e9, 1 and 1: what is pressed together to next to nothing. The symmetric part is indefinite either
// way.
TEST(GrowthOfMatrices, SeesWhatGrowsMuchFasterThanTheRest) {
  ThreeDiagonals K(3, 2.5, 1, 0);
  K.values.front() = -1e9;
  EXPECT_GT(growth_of(K), kGrows);
  K.values.front() = 1e9;
  EXPECT_LE(growth_of(K), kGrows);
}

// λ² − (K₁₁/M₁₁ + K₂₂/M₂₂) λ + det K/det M = 0: its sum of roots changes its sign with M, that of its product
// cannot.
TEST(GrowthOfMatrices, DependsOnTheDampingWhereItIsFlutterAlone) {
  ThreeDiagonals flutter(2, -3, 2, 3), divergence(2, -1, 2, 1), M(2, 0, 1, 0);
  flutter.values.back() = divergence.values.back() = -1;
  for (const double first : {1.0, 4.0}) {
    M.values.front() = first;
    EXPECT_EQ(growth_of(flutter, M) > kGrows, 2 / first - 1 < 0) << first;
    EXPECT_GT(growth_of(divergence, M), kGrows) << first;
  }
}

// λ² − (K₁₁ + K₂₂) λ + det K = 0.
TEST(GrowthOfMatrices, TellsHowFastItGrowsAndSwings) {
  const ThreeDiagonals M(2, 0, 1, 0), flutter(2, -3, -0.5, 3), divergence(2, 3, 2, 3.1);
  const Growth swings = find_growth(flutter.pattern, flutter.values, M.values, make_factorisation);
  EXPECT_NEAR(swings.rate, 0.5, 1e-6);
  EXPECT_NEAR(swings.frequency, 3, 1e-6);
  const Growth topples = find_growth(divergence.pattern, divergence.values, M.values, make_factorisation);
  EXPECT_NEAR(topples.rate, std::sqrt(9.3) - 2, 1e-6);
  EXPECT_EQ(topples.frequency, 0);
}

/// A float at the head of a pressed spring along x, which something pushes sideways as it turns; it may move
/// in x and y. Of the spring, with l² = 0.55 l₀²:
///   K₁₁ = k (3 l² − l₀²)/2l₀² = 0.325 k,   K₂₂ = k (l² − l₀²)/2l₀² = −0.225 k,   K₁₂ = −K₂₁ = 3 push
Growth find_growth_of_float(double push, double along_x, double along_y) {
  Sketch s;
  s.scene.water.gravity = 0;
  s.scene.current.samples = {{0, {along_x, along_y, 0}}};
  const auto foot = s.node(0, 0, 0, kAllAxes), head = s.node(std::sqrt(0.55), 0, 0, 1 << 2);
  s.part("spring", "test/spring", {{"k", 1000.0}}, {foot, head}).data["rest_length"] = {1};
  s.part("push", "test/follower", {{"k", push}}, {foot, head}).data["rest_length"] = {1};
  s.part("float", "float/float", {{"float.buoyancy", 10.0}, {"float.diameter", 0.2}}, {head})
      .data["pieces"] = {1};
  Assembled a(s.scene);
  return find_growth(a.assembler, a.assembler.start(), make_factorisation);
}

double growth_of_float(double push, double along_x, double along_y) {
  return find_growth_of_float(push, along_x, along_y).per_power;
}

// A float's drag damps twice as much along the flow as across it: K₁₁/2 + K₂₂ < 0 < K₁₁ + K₂₂/2.
TEST(Growth, IsFlutterByTheDampingOfTheFlow) {
  EXPECT_GT(growth_of_float(200, 1, 0), kGrows);
  EXPECT_LE(growth_of_float(200, 0, 1), kGrows);
}

// M = c diag(2, 1), c = ½ ρ C_d (π/4) D² |W|, but for the little of the linear stiffness:
//   Re λ = ½ (K₁₁/2 + K₂₂)/c,   |λ|² = det K/2c²
TEST(Growth, IsToldInSeconds) {
  const double c = 0.5 * 1025 * 0.47 * 0.25 * std::numbers::pi * 0.04,
               rate = 0.5 * (0.225 - 0.325 / 2) * 1000 / c;
  const Growth growth = find_growth_of_float(200, 1, 0);
  EXPECT_NEAR(growth.rate, rate, 0.03 * rate);
  const double squared = (9 * 200.0 * 200 - 0.325 * 0.225 * 1e6) / (2 * c * c) - rate * rate;
  EXPECT_NEAR(growth.frequency, std::sqrt(squared), 0.03 * std::sqrt(squared));
}

// det K = −0.325 x 0.225 k² + 9 push² < 0.
TEST(Growth, IsDivergenceWhateverTheFlow) {
  EXPECT_GT(growth_of_float(30, 1, 0), kGrows);
  EXPECT_GT(growth_of_float(30, 0, 1), kGrows);
}

// K₁₁ + K₂₂ > 0: by the linear stiffness alone, it rests.
TEST(Growth, IsJudgedByTheLinearStiffnessInStillWater) {
  EXPECT_LE(growth_of_float(200, 0, 0), kGrows);
  EXPECT_GT(growth_of_float(30, 0, 0), kGrows);
}

}  // namespace
}  // namespace netloft::test
