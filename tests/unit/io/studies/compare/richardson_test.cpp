// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/richardson.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::studies {
namespace {

/// Values f* + C hᵖ on meshes of the widths h.
std::vector<double> samples(double limit, double C, double p, const std::vector<double>& h) {
  std::vector<double> f;
  for (const double width : h) f.push_back(limit + C * std::pow(width, p));
  return f;
}

TEST(Richardson, ObservesTheOrderOfAPowerLaw) {
  for (const double p : {0.5, 1.0, 1.37, 2.0, 4.0})
    for (const auto& h : {std::vector<double>{1. / 8, 1. / 16, 1. / 32}, {1. / 10, 1. / 15, 1. / 40}}) {
      const auto f = samples(3, -2, p, h);
      EXPECT_NEAR(observed_order(std::abs(f[1] - f[0]), std::abs(f[2] - f[1]), h[0], h[1], h[2]), p, 1e-9);
    }
}

TEST(Richardson, KnowsNoOrderWhereNothingConverges) {
  EXPECT_TRUE(std::isnan(observed_order(1, 1, 4, 2, 1)));  // equal differences do not converge
  EXPECT_TRUE(std::isnan(observed_order(1, 2, 4, 2, 1)));
  EXPECT_TRUE(std::isnan(observed_order(0, 0, 4, 2, 1)));
  EXPECT_TRUE(std::isnan(observed_order(1, 0, 4, 2, 1)));
}

TEST(Richardson, FindsTheLimitOfAPowerLaw) {
  const std::vector<double> h{4, 2, 1};
  const auto f = samples(10, 0.3, 1.5, h);
  for (std::size_t asked = 0; asked < 3; ++asked) {
    const Trend t = find_trend(f, h, asked);
    EXPECT_TRUE(t.steady);
    EXPECT_FALSE(t.diverges);
    EXPECT_NEAR(t.order, 1.5, 1e-9);
    EXPECT_NEAR(t.limit, 10, 1e-9);
  }
}

// The values are 12.4, 10.85, 10.3. Their differences from the limit 10 are 2.4, 0.85, 0.3; from the limit of
// first order 9.6 they are 2.8, 1.25, 0.7; from the other values at most 2.1, 1.55, 2.1.
TEST(Richardson, BoundsTheErrorByTheLargestThatItMayBe) {
  const std::vector<double> h{4, 2, 1};
  const auto f = samples(10, 0.3, 1.5, h);
  EXPECT_NEAR(find_trend(f, h, 0).error, 2 * 2.8, 1e-9);
  EXPECT_NEAR(find_trend(f, h, 1).error, 2 * (f[0] - f[1]), 1e-9);
  EXPECT_NEAR(find_trend(f, h, 2).error, 2 * 2.1, 1e-9);
}

TEST(Richardson, BelievesTheOrderOfSimilarMeshes) {
  const std::vector<double> h{4, 2, 1};
  const auto f = samples(10, 0.3, 1.5, h);
  EXPECT_NEAR(find_trend(f, h, 2, true).error, 1.25 * 0.3, 1e-9);
  EXPECT_NEAR(find_trend({1.0, 1.3, 1.2}, h, 2, true).error, 2 * 0.2, 1e-12) << "if there is one";
}

TEST(Richardson, UsesTheThreeFinestOfManyMeshes) {
  const Trend t = find_trend({50, 12.4, 10 + 0.3 * std::pow(2, 1.5), 10.3}, {8, 4, 2, 1}, 3);
  EXPECT_NEAR(t.limit, 10, 1e-9);
  EXPECT_NEAR(t.error, 2 * 2.1, 1e-9);
}

TEST(Richardson, AssumesFirstOrderOfTwoMeshes) {
  const Trend t = find_trend({1.2, 1.1}, {2, 1}, 1);
  EXPECT_TRUE(std::isnan(t.order));
  EXPECT_FALSE(t.steady);
  EXPECT_NEAR(t.limit, 1.0, 1e-12);
  EXPECT_NEAR(t.error, 0.2, 1e-12);
}

TEST(Richardson, HasNoLimitWhereLevelsTurnRound) {
  const Trend t = find_trend({1.0, 1.3, 1.2}, {4, 2, 1}, 2);
  EXPECT_FALSE(t.steady);
  EXPECT_TRUE(std::isnan(t.limit));
  EXPECT_NEAR(t.error, 2 * 0.2, 1e-12);
}

TEST(Richardson, DoesNotBelieveAnOrderThatNoElementHas) {
  EXPECT_FALSE(find_trend({1.0, 2.0, 2.001}, {4, 2, 1}, 2).steady);  // observed order log₂ 1000 ≈ 10
  EXPECT_FALSE(find_trend(samples(1, 1, 3, {4, 2, 1}), {4, 2, 1}, 2).steady);
  EXPECT_FALSE(find_trend({1.0, 2.0, 2.95}, {4, 2, 1}, 2).steady);  // observed order log₂ (1/0.95) ≈ 0.07
  EXPECT_FALSE(find_trend(samples(1, 1, 0.4, {4, 2, 1}), {4, 2, 1}, 2).steady);
}

TEST(Richardson, SaysWhatDoesNotConverge) {
  EXPECT_TRUE(find_trend({3.7, 4.6, 5.9}, {4, 2, 1}, 2).diverges);
  EXPECT_FALSE(find_trend({3.7, 5.3, 5.9}, {4, 2, 1}, 2).diverges) << "differences fall";
  EXPECT_FALSE(find_trend({3.7, 4.6, 3.9}, {4, 2, 1}, 2).diverges) << "it turns round";
  EXPECT_FALSE(find_trend({3.70, 3.71, 3.73}, {4, 2, 1}, 2).diverges) << "too little";
}

TEST(Richardson, CallsOrdersSteadyThatAgree) {
  EXPECT_TRUE(is_steady(std::vector<double>{1.8, 2.1}));
  EXPECT_FALSE(is_steady(std::vector<double>{0.9, 2.1}));
  EXPECT_FALSE(is_steady(std::vector<double>{1.0, std::nan("")}));
  EXPECT_FALSE(is_steady(std::vector<double>{}));
}

}  // namespace
}  // namespace netloft::studies
