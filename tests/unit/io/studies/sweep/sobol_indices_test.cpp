// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/sobol_indices.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::studies {
namespace {

constexpr double kSobolPi = 3.141592653589793;

/// The function of T. Ishigami, T. Homma, First International Symposium on Uncertainty Modeling and Analysis,
/// 1990, with a = 7 and b = 0.1 over −π to π. With V₁ = (1 + b π⁴/5)²/2, V₂ = a²/8, V₁₃ = 8 b² π⁸/225 and V
/// their sum,
///   S = (V₁, V₂, 0)/V,   T = (V₁ + V₁₃, V₂, V₁₃)/V                                          (1)
double ishigami(const std::vector<double>& u) {
  const auto x = [&](std::size_t i) { return kSobolPi * (2 * u[i] - 1); };
  return std::sin(x(0)) + 7 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}
constexpr double kFirst[] = {0.3139, 0.4424, 0}, kTotal[] = {0.5576, 0.4424, 0.2437};

TEST(SobolIndices, AreThoseOfIshigamisFunction) {
  const SobolIndices found = sobol_indices(ishigami, 3);
  EXPECT_NEAR(found.mean, 3.5, 0.01);  // a/2
  EXPECT_NEAR(found.deviation,
              std::sqrt(0.5 + 49.0 / 8 + 0.02 * std::pow(kSobolPi, 4) + std::pow(kSobolPi, 8) / 1800), 0.01);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [first, total] = found.variables[i];
    EXPECT_NEAR(first.value, kFirst[i], std::max(first.error, 1e-4)) << i;
    EXPECT_NEAR(total.value, kTotal[i], std::max(total.error, 1e-4)) << i;
    EXPECT_LT(first.error, 0.02) << i;
    EXPECT_LT(total.error, 0.02) << i;
  }
}
// For the linear function Σ a_i x_i, S_i = T_i = a_i²/Σ a².
TEST(SobolIndices, OfALinearFunctionAreSquaresOfItsSlopes) {
  const SobolIndices found = sobol_indices([](const auto& u) { return 5 + u[0] - 2 * u[1] + 3 * u[2]; }, 3);
  const double expected[] = {1.0 / 14, 4.0 / 14, 9.0 / 14};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.variables[i].first.value, expected[i], 0.005);
    EXPECT_NEAR(found.variables[i].total.value, expected[i], 0.005);
    EXPECT_LT(found.variables[i].total.error, 0.005);
  }
}
TEST(SobolIndices, ErrorsFallWithThePoints) {
  const double coarse = sobol_indices(ishigami, 3, {64, 8}).variables[0].total.error;
  const double fine = sobol_indices(ishigami, 3, {2048, 8}).variables[0].total.error;
  EXPECT_LT(fine, coarse / 4);
}
TEST(SobolIndices, OfAConstantAreZero) {
  const SobolIndices found = sobol_indices([](const auto&) { return 42.0; }, 2);
  EXPECT_EQ(found.mean, 42);
  for (const SobolIndex& index : found.variables) {
    EXPECT_EQ(index.first.value, 0);
    EXPECT_EQ(index.total.error, 0);
  }
}

}  // namespace
}  // namespace netloft::studies
