// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "solvers/newton/line_search.hpp"

namespace netloft::newton {
namespace {

/// Falls as (1 − t)², until at `kink` something stiff becomes taut; beside so much energy that neither shows.
struct Kinked {
  double kink, stiffness;
  std::optional<Sample> operator()(double t) const {
    const double beyond = std::max(0.0, t - kink);
    return Sample{t, 1e6 + 1e-12 * ((1 - t) * (1 - t) + stiffness * beyond * beyond),
                  1e-12 * (-2 * (1 - t) + 2 * stiffness * beyond)};
  }
};

TEST(SlopeSearch, EndsBehindTheKinkWhereTheSlopeHasNearlyGone) {
  for (const double stiffness : {1e2, 1e4, 1e6}) {
    const Kinked m{0.3, stiffness};
    const auto found = SlopeSearch{}(m, *m(0));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->t, 0.3 + 0.7 / stiffness, 0.11 * 0.7 / stiffness + 0.11 * 1 / stiffness);
    EXPECT_LE(std::abs(found->slope), 0.1 * 2e-12);
    EXPECT_EQ(m(0)->value, found->value) << "no digit of the energy tells";
  }
}

TEST(SlopeSearch, TakesAWholeStepThatLeadsDownhillAllTheWay) {
  const Kinked m{2, 1};
  const auto found = SlopeSearch{}(m, *m(0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->t, 1);
}

TEST(SlopeSearch, FindsNothingWhereThereAreNoForcesOrNoEndOfThem) {
  const auto nowhere = [](double) { return std::optional<Sample>(); };
  const auto jump = [](double t) { return std::optional<Sample>({t, 0, t < 0.3 ? -1.0 : 1.0}); };
  EXPECT_FALSE(SlopeSearch{}(nowhere, {0, 0, -1}));
  EXPECT_FALSE(SlopeSearch{}(jump, {0, 0, -1}));
}

}  // namespace
}  // namespace netloft::newton
