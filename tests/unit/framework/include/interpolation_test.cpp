// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/interpolation.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

const std::vector<double> kX{0, 1, 1.5, 3, 4, 6}, kRises{0, 0.1, 2, 2.5, 2.6, 7};

double slope_of(const Curve& c, double x) { return c.at(Dual<1, 1>::variable(x, 0)).gradient[0]; }

TEST(Curve, GoesThroughItsSamples) {
  const Curve c(kX, kRises);
  for (std::size_t i = 0; i < kX.size(); ++i) EXPECT_NEAR(c.at(kX[i]), kRises[i], 1e-14);
}

TEST(Curve, RisesWhereItsSamplesRise) {
  const Curve c(kX, kRises);
  for (double x = 0, last = -1; x <= 6; x += 0.01) {
    EXPECT_GE(c.at(x), last);
    EXPECT_GE(c.at(x), 0);
    EXPECT_LE(c.at(x), 7);
    last = c.at(x);
  }
}

TEST(Curve, IsNeverAboveOrBelowItsSamples) {
  const Curve c({0, 1, 2, 3, 4}, {0, 2, 2, -1, 0});
  for (double x = 0; x <= 4; x += 0.01) {
    EXPECT_LE(c.at(x), 2 + 1e-15);
    EXPECT_GE(c.at(x), -1 - 1e-15);
  }
}

/// The slope equals differences of the curve and has no jumps, not even at the ends.
TEST(Curve, HasASlopeWithoutJumps) {
  const Curve c(kX, kRises);
  for (double x = -0.5; x <= 6.5; x += 0.01) {
    constexpr double h = 1e-6;
    EXPECT_NEAR(slope_of(c, x), (c.at(x + h) - c.at(x - h)) / (2 * h), 2e-5) << x;
    EXPECT_NEAR(slope_of(c, x + h), slope_of(c, x - h), 1e-4) << x;
  }
}

TEST(Curve, StaysAtItsEdgesAndSaysSo) {
  const Curve c(kX, kRises);
  EXPECT_EQ(c.at(-5.0), 0);
  EXPECT_EQ(c.at(99.0), 7);
  EXPECT_FALSE(c.covers(-0.01));
  EXPECT_TRUE(c.covers(0) && c.covers(6));
  EXPECT_EQ(Curve({2}, {5}).at(17.0), 5);
  EXPECT_EQ(Curve().at(1.0), 0);
}

const std::vector<double> kU{0, 1, 3, 4}, kV{-1, 0, 2};

double hill(double x, double y) { return std::sin(0.5 * x) * std::cos(0.4 * y) + 0.1 * x; }

Surface hills() {
  std::vector<double> f;
  for (const double x : kU)
    for (const double y : kV) f.push_back(hill(x, y));
  return {kU, kV, f};
}

TEST(Surface, GoesThroughItsSamplesAndIsTheCurveAlongItsGrid) {
  const Surface s = hills();
  for (const double y : kV) {
    std::vector<double> along;
    for (const double x : kU) along.push_back(hill(x, y));
    const Curve c(kU, along);
    for (double x = 0; x <= 4; x += 0.1) EXPECT_NEAR(s.at(x, y), c.at(x), 1e-14);
  }
}

TEST(Surface, HasSlopesWithoutJumps) {
  const Surface s = hills();
  using D = Dual<2, 1>;
  const auto slopes = [&](double x, double y) { return s.at(D::variable(x, 0), D::variable(y, 1)).gradient; };
  constexpr double h = 1e-6;
  for (double x = -0.5; x < 4.5; x += 0.05)
    for (double y = -1.5; y < 2.5; y += 0.05) {
      const auto g = slopes(x, y);
      EXPECT_NEAR(g[0], (s.at(x + h, y) - s.at(x - h, y)) / (2 * h), 1e-5);
      EXPECT_NEAR(g[1], (s.at(x, y + h) - s.at(x, y - h)) / (2 * h), 1e-5);
      EXPECT_NEAR(slopes(x + h, y)[1], slopes(x - h, y)[1], 1e-4);
      EXPECT_NEAR(slopes(x, y + h)[0], slopes(x, y - h)[0], 1e-4);
    }
}

TEST(Surface, ReadsAGridRowByRow) {
  const double rows[] = {0, 10, 1, 0, 20, 2, 5, 10, 3, 5, 20, 4};
  const Surface s(netloft_table{rows, 4, 3}, 2);
  EXPECT_EQ(s.at(0.0, 10.0), 1);
  EXPECT_EQ(s.at(0.0, 20.0), 2);
  EXPECT_EQ(s.at(5.0, 10.0), 3);
  EXPECT_EQ(s.at(5.0, 20.0), 4);
  EXPECT_TRUE(s.covers(2, 15));
  EXPECT_FALSE(s.covers(2, 21) || s.covers(6, 15));
}

}  // namespace
}  // namespace netloft
