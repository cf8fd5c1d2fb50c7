// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/second_order_cone.hpp"

#include <gtest/gtest.h>

namespace netloft::tension {
namespace {

constexpr cone::Point kZ{1.7, 0.3, -0.9, 1.1}, kY{5, -2, 1, 3.5};

TEST(Cone, ScalingMapsBothPointsToOne) {
  const cone::Scaling W(kZ, kY);
  const cone::Point of_z = W.scaled(kZ), of_y = W.unscaled(kY), twice = W.scaled(W.scaled(kZ));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(of_z[i], of_y[i], 1e-13);
    EXPECT_NEAR(twice[i], kY[i], 1e-12) << "W W z = y";
    double squared = 0;
    for (std::size_t j = 0; j < 4; ++j) squared += W.squared(i, j) * kZ[j];
    EXPECT_NEAR(squared, kY[i], 1e-12);
  }
}

TEST(Cone, QuotientUndoesTheProduct) {
  const cone::Point x{0.2, -4, 1, 3}, again = cone::quotient(cone::product(kY, x), kY);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(again[i], x[i], 1e-14);
}

TEST(Cone, StepEndsWhereThePointWouldLeave) {
  const cone::Point d{-1, 0.2, 0.5, 0.1}, outward{1, 0.5, 0.5, 0.5};
  const double a = cone::step_to_boundary(kZ, d);
  cone::Point there = kZ;
  for (std::size_t i = 0; i < 4; ++i) there[i] += a * d[i];
  EXPECT_GT(a, 0);
  EXPECT_NEAR(cone::determinant(there), 0, 1e-14);
  EXPECT_EQ(cone::step_to_boundary(kZ, {-kZ[0], -kZ[1], -kZ[2], -kZ[3]}), 1) << "through the tip";
  EXPECT_GT(there[0], 0);
  EXPECT_EQ(cone::step_to_boundary(kZ, outward), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace netloft::tension
