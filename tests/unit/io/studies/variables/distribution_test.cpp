// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/variables/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::studies {
namespace {

using Kind = Distribution::Kind;

TEST(Distribution, IsUniform) {
  const Distribution d{Kind::uniform};
  EXPECT_DOUBLE_EQ(quantile(d, {10, 20}, 0.25), 12.5);
}
TEST(Distribution, IsUniformInTheLogarithm) {
  const Distribution d{Kind::logarithmic};
  EXPECT_NEAR(quantile(d, {1, 100}, 0.5), 10, 1e-12);
  EXPECT_NEAR(quantile(d, {1, 100}, 0.25), std::sqrt(10.0), 1e-12);
}
// Expected quantiles of the standard normal distribution are from Abramowitz and Stegun, table 26.1.
TEST(Distribution, IsNormal) {
  const Distribution d{Kind::normal, 5, 2};
  const Interval wide{-1000, 1000};
  EXPECT_NEAR(quantile(d, wide, 0.5), 5, 1e-12);
  EXPECT_NEAR(quantile(d, wide, 0.975), 5 + 2 * 1.959963985, 1e-8);
  EXPECT_NEAR(quantile(d, wide, 0.01), 5 - 2 * 2.326347874, 1e-8);
}
TEST(Distribution, CutsTheNormalDistributionOffAtBothEnds) {
  const Distribution d{Kind::normal, 0, 1};
  const Interval cut{-1, 2};
  EXPECT_NEAR(quantile(d, cut, 1e-12), -1, 1e-9);
  EXPECT_NEAR(quantile(d, cut, 1 - 1e-12), 2, 1e-9);
  // F(0) = 0.5, F(-1) = 0.158655254, F(2) = 0.977249868 (Abramowitz and Stegun, table 26.1).
  EXPECT_NEAR(quantile(d, cut, (0.5 - 0.158655254) / (0.977249868 - 0.158655254)), 0, 1e-8);
}
TEST(Distribution, NeverLeavesItsInterval) {
  for (const Kind kind : {Kind::uniform, Kind::logarithmic, Kind::normal}) {
    const Interval interval{0.1, 0.3};
    for (const double p : {0x1p-54, 0.3, 1 - 0x1p-53})
      EXPECT_TRUE(interval.contains(quantile({kind, 0.2, 0.05}, interval, p)));
  }
}

}  // namespace
}  // namespace netloft::studies
