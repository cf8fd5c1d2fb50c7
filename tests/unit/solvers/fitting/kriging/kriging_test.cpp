// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/fitting/kriging/kriging.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace netloft {
namespace {

using Numbers = std::vector<double>;
using Points = std::vector<Numbers>;

double matern(double r) { return (1 + std::sqrt(5) * r + 5 * r * r / 3) * std::exp(-std::sqrt(5) * r); }

/// All pairs of speeds and depths, a row for each.
Points grid(int speeds, int depths) {
  Points points;
  for (int i = 0; i < speeds; ++i)
    for (int j = 0; j < depths; ++j)
      points.push_back({2 + 2.0 * i / (speeds - 1), 50 + 100.0 * j / (depths - 1)});
  return points;
}

/// A function like a headline height over speed and depth: range 2.5 to 10.
double height(const Numbers& at) {
  return 12 / (at[0] * std::sqrt(at[0] / 2)) + 2 * std::sin(at[1] / 40) + 0.01 * at[0] * at[1];
}

Numbers values_of(const Points& points) {
  Numbers values;
  for (const Numbers& at : points) values.push_back(height(at));
  return values;
}

// n = 2, y = (0, 1) at 0 and 1, ℓ = 0.7: both weights are 1/2 ± (k(u) − k(1 − u)) / (2 (1 + ν − k(1))).
TEST(Kriging, IsWhatTwoPointsGiveByHand) {
  const KrigingScales scales{KrigingScales::Correlation::matern, {0.7}, 1e-3};
  const Kriging kriging({{0}, {1}}, {0, 1}, &scales);
  const double k = matern(1 / 0.7), nu = 1e-3;
  for (const double u : {0.1, 0.4, 0.9}) {
    const double a = matern(u / 0.7), b = matern((1 - u) / 0.7);
    const KrigingValue found = kriging.at({u});
    EXPECT_NEAR(found.value, 0.5 + (b - a) / (2 * (1 + nu - k)), 1e-12);
    // y − β = (−1/2, 1/2): σ² = 1/2 / (1 + ν − k)
    const double along = (a + b) / 2, across = (a - b) / 2, sum = 1 + nu + k, difference = 1 + nu - k;
    const double rest = 1 + nu - 2 * along * along / sum - 2 * across * across / difference +
                        (1 - 2 * along / sum) * (1 - 2 * along / sum) * sum / 2;
    EXPECT_NEAR(found.deviation, std::sqrt(0.5 / difference * rest), 1e-12);
  }
}
TEST(Kriging, SaysOfAPointLeftOutWhatAllOthersSay) {
  const Points all = grid(5, 4);
  const Numbers values = values_of(all);
  for (const auto kind : {KrigingScales::Correlation::matern, KrigingScales::Correlation::gaussian}) {
    const KrigingScales scales{kind, {0.8, 0.5}, 1e-6};
    const std::vector<std::size_t> group{8, 9, 10, 11};  // the third speed
    const Numbers residuals = Kriging(all, values, &scales).residuals_without(group);
    Points rest;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i < 8 || i > 11) rest.push_back(all[i]);
    const Kriging others(rest, values_of(rest), &scales);
    for (std::size_t g = 0; g < group.size(); ++g)
      EXPECT_NEAR(residuals[g], values[group[g]] - others.at(all[group[g]]).value, 1e-7);
  }
}
TEST(Kriging, HasTheValuesAtItsPoints) {
  const Points points = grid(5, 8);
  const Kriging kriging(points, values_of(points));
  for (const Numbers& at : points) EXPECT_NEAR(kriging.at(at).value, height(at), 1e-4);
}
TEST(Kriging, WithTheScalesOfAnotherIsTheSame) {
  const Points points = grid(5, 8);
  const Kriging kriging(points, values_of(points));
  const auto scales = kriging.scales();
  ASSERT_TRUE(scales);
  const Kriging again(points, values_of(points), &*scales);
  const Numbers at{2.7, 81};
  EXPECT_NEAR(again.at(at).value, kriging.at(at).value, 1e-9);
  EXPECT_NEAR(again.at(at).deviation, kriging.at(at).deviation, 1e-9);
  EXPECT_EQ(kriging.value_at(at), kriging.at(at).value);
  EXPECT_FALSE(Kriging(points, Numbers(points.size(), 1.0)).scales());
}
TEST(Kriging, FindsASmoothFunctionBetweenFewPoints) {
  const Points points = grid(5, 8);
  const Kriging kriging(points, values_of(points));
  double worst = 0;
  for (double speed = 2.05; speed < 4; speed += 0.1)
    for (double depth = 52; depth < 150; depth += 7) {
      const KrigingValue found = kriging.at({speed, depth});
      worst = std::max(worst, std::abs(found.value - height({speed, depth})));
    }
  EXPECT_LT(worst, 0.02);  // 0.3 % of the range
}
// The function is linear in two variables with few values and constant in the third, like the pull of a
// weight.
TEST(Kriging, FindsAPlaneToRoundOff) {
  Points points;
  Numbers values;
  for (int draw = 0; draw < 6; ++draw)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j) {
        points.push_back({1000 + 10.0 * i, 2000 + 1000.0 * j, 8.5 + std::fmod(2.3 * draw, 3.4)});
        values.push_back(20 + 0.0092457 * points.back()[1] - 0.0388320 * (points.back()[0] - 1000));
      }
  const KrigingValue found = Kriging(points, values).at({1005, 2500, 9});
  EXPECT_NEAR(found.value, 20 + 0.0092457 * 2500 - 0.0388320 * 5, 1e-6);
  EXPECT_LT(found.deviation, 1e-6);
}
TEST(Kriging, IsThatOfOtherUnits) {
  const Points points = grid(4, 5);
  Points other = points;
  for (Numbers& at : other) at = {at[0] * 1852 / 3600, -at[1] * 100};
  const Numbers values = values_of(points);
  Numbers millimetres = values;
  for (double& value : millimetres) value = 1000 * value + 5e5;
  const KrigingValue a = Kriging(points, values).at({2.7, 80});
  const KrigingValue b = Kriging(other, millimetres).at({2.7 * 1852 / 3600, -8000});
  EXPECT_NEAR(b.value, 1000 * a.value + 5e5, 1e-3);
  EXPECT_NEAR(b.deviation, 1000 * a.deviation, 1e-3 * b.deviation + 1e-6);
}
TEST(Kriging, OfEqualValuesIsThatValue) {
  const Kriging kriging(grid(3, 3), Numbers(9, 42.0));
  EXPECT_EQ(kriging.at({2.3, 77}).value, 42);
  EXPECT_EQ(kriging.at({2.3, 77}).deviation, 0);
  EXPECT_EQ(kriging.residuals_without({1, 2}), (Numbers{0, 0}));
}
// The functions are sums of waves of random length and direction, as is a normal process: therefore 19 of 20
// values are within 2 s of the prediction.
TEST(Kriging, DeviatesByItsDeviation) {
  std::mt19937_64 dice(7);
  const auto uniform = [&] { return static_cast<double>(dice() >> 11) * 0x1p-53; };
  int within = 0, all = 0;
  for (int trial = 0; trial < 30; ++trial) {
    Points waves;
    for (int k = 0; k < 12; ++k) waves.push_back({4 * uniform() - 2, 4 * uniform() - 2, 6.28 * uniform()});
    const auto f = [&](const Numbers& at) {
      double sum = 0;
      for (const Numbers& w : waves) sum += std::cos(3 * (w[0] * at[0] + w[1] * at[1]) + w[2]);
      return sum;
    };
    Points points;
    Numbers values;
    for (int i = 0; i < 40; ++i) points.push_back({uniform(), uniform()}), values.push_back(f(points.back()));
    const Kriging kriging(points, values);
    for (int i = 0; i < 20; ++i, ++all) {
      const Numbers at{0.1 + 0.8 * uniform(), 0.1 + 0.8 * uniform()};
      const KrigingValue found = kriging.at(at);
      within += std::abs(found.value - f(at)) <= 2 * found.deviation;
      EXPECT_LT(found.deviation, 3);  // of values between -12 and 12
    }
  }
  EXPECT_GE(within, 0.9 * all);
}
// If values scatter, the prediction does not pass through them.
TEST(Kriging, SmoothsWhatScatters) {
  std::mt19937_64 dice(11);
  Points points;
  Numbers values;
  for (int i = 0; i < 100; ++i) {
    points.push_back({i / 99.0});
    values.push_back(points.back()[0] + 0.2 * (static_cast<double>(dice() >> 11) * 0x1p-53 - 0.5));
  }
  const Kriging kriging(points, values);
  EXPECT_NEAR(kriging.at({0.505}).value, 0.505, 0.03);
  EXPECT_NEAR(kriging.at({0.505}).deviation, 0.2 / std::sqrt(12), 0.02);
}

}  // namespace
}  // namespace netloft
