// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "solvers/methods/newton/line_search.hpp"

namespace netloft::newton {
namespace {

constexpr Refinement kRefinement{.margin = 0.1, .most = 4};
constexpr SlopeSearch kSlopeSearch{.flatness = 0.1, .refinement = kRefinement};

/// A merit function that falls as (1 − t)² until a stiff member becomes taut at `kink`. It contains so much
/// energy that rounding hides its changes.
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
    const auto found = kSlopeSearch(m, *m(0));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->t, 0.3 + 0.7 / stiffness, 0.11 * 0.7 / stiffness + 0.11 * 1 / stiffness);
    EXPECT_LE(std::abs(found->slope), 0.1 * 2e-12);
    EXPECT_EQ(m(0)->value, found->value) << "no digit of the energy tells";
  }
}

TEST(SlopeSearch, TakesAWholeStepThatLeadsDownhillAllTheWay) {
  const Kinked m{2, 1};
  const auto found = kSlopeSearch(m, *m(0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->t, 1);
}

TEST(SlopeSearch, TakesAWholeStepBehindWhichTheSlopeHasNearlyGone) {
  int asked = 0;
  const auto m = [&](double t) {
    ++asked;
    return std::optional<Sample>({t, 0, -1 + 1.001 * t});
  };
  const auto found = kSlopeSearch(m, {0, 0, -1});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->t, 1);
  EXPECT_EQ(asked, 1);
}

// The merit falls to t = 0.1 and then rises to a hill. Behind the hill the slope is negative again, as if the
// merit had fallen all the way.
TEST(SlopeSearch, CrossesNoHillThatRoundingDoesNotExplain) {
  const auto hill = [](double t) {
    return std::optional<Sample>({t, t > 0.2 ? 5.0 : 0.0, t > 0.2 ? -1e-3 : t - 0.1});
  };
  SlopeSearch search = kSlopeSearch;
  search.noise = 1e-6;
  const auto found = search(hill, {0, 0, -0.1});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->t, 0.1, 0.02);
  search.noise = 10;
  EXPECT_EQ(search(hill, {0, 0, -0.1})->t, 1) << "here it does";
}

TEST(SlopeSearch, FindsNothingWhereThereAreNoForcesOrNoEndOfThem) {
  const auto nowhere = [](double) { return std::optional<Sample>(); };
  const auto jump = [](double t) { return std::optional<Sample>({t, 0, t < 0.3 ? -1.0 : 1.0}); };
  EXPECT_FALSE(kSlopeSearch(nowhere, {0, 0, -1}));
  EXPECT_FALSE(kSlopeSearch(jump, {0, 0, -1}));
}

}  // namespace
}  // namespace netloft::newton
