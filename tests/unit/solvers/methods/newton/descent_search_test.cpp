// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/descent_search.hpp"

#include <gtest/gtest.h>

namespace netloft::newton {
namespace {

/// −a t²/2 + b t⁴/4, like an energy along a direction of negative curvature, with its minimum at t = √(a/b).
auto buckling(double a, double b) {
  return [=](double t) {
    return std::optional(Sample{t, -a * t * t / 2 + b * t * t * t * t / 4, -a * t + b * t * t * t});
  };
}

constexpr Sample kSaddle{};
constexpr DescentSearch kSearch{{.margin = 0.1, .most = 4}};

TEST(DescentSearch, FindsHowFarItFallsWhateverTheScale) {
  for (const double furthest : {3e-6, 4e-4, 0.02, 0.7}) {
    const auto found = kSearch(buckling(1, 1 / (furthest * furthest)), kSaddle, 0);
    ASSERT_TRUE(found) << furthest;
    EXPECT_LE(found->t, furthest);
    EXPECT_GT(found->t, 0.8 * furthest);
  }
}

TEST(DescentSearch, GoesNowhereUphill) { EXPECT_FALSE(kSearch(buckling(-1, 1), kSaddle, 0)); }

TEST(DescentSearch, StopsShortOfWhereThereAreNoForces) {
  const auto found =
      kSearch([](double t) { return t < 0.05 ? buckling(1, 0)(t) : std::optional<Sample>(); }, kSaddle, 0);
  ASSERT_TRUE(found);
  EXPECT_LT(found->t, 0.05);
  EXPECT_GT(found->t, 0.01);
}

TEST(DescentSearch, GoesNoFurtherThanTheLongestWhereItFallsForEver) {
  const auto found = kSearch(buckling(1, 0), kSaddle, 0);
  ASSERT_TRUE(found);
  EXPECT_LT(found->t, kSearch.longest());
}

}  // namespace
}  // namespace netloft::newton
