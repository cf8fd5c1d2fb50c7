// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/unit_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace netloft::studies {
namespace {

/// The number of intervals with a point, if a dimension is divided into as many equal intervals as there are
/// points.
std::size_t intervals_hit(const std::vector<std::vector<double>>& points, std::size_t dimension) {
  std::set<std::size_t> hit;
  for (const auto& p : points)
    hit.insert(static_cast<std::size_t>(p[dimension] * static_cast<double>(points.size())));
  return hit.size();
}

TEST(UnitPoints, OfALatinHypercubeHaveOneInEveryInterval) {
  const auto points = unit_points(Sampling::latin_hypercube, 50, 7, 3);
  ASSERT_EQ(points.size(), 50u);
  for (std::size_t d = 0; d < 7; ++d) EXPECT_EQ(intervals_hit(points, d), 50u);
}
TEST(UnitPoints, OfSobolsSequenceHaveOneInEveryIntervalOfAPowerOfTwo) {
  const auto points = unit_points(Sampling::sobol, 128, 40, 3);
  for (std::size_t d = 0; d < 40; ++d) EXPECT_EQ(intervals_hit(points, d), 128u);
}
// The first two dimensions are a (0, m, 2)-net in base 2 (Sobol 1967): every box of 2^-a by 2^(a-m) holds one
// point.
TEST(UnitPoints, OfSobolsSequenceFillEveryElementaryBoxOfAPlane) {
  const auto points = unit_points(Sampling::sobol, 64, 2, 11);
  for (int a = 0; a <= 6; ++a) {
    std::set<std::pair<int, int>> boxes;
    for (const auto& p : points)
      boxes.emplace(static_cast<int>(std::ldexp(p[0], a)), static_cast<int>(std::ldexp(p[1], 6 - a)));
    EXPECT_EQ(boxes.size(), 64u) << a;
  }
}
TEST(UnitPoints, DependOnTheSeedAlone) {
  for (const Sampling sampling : {Sampling::latin_hypercube, Sampling::sobol}) {
    EXPECT_EQ(unit_points(sampling, 20, 3, 1), unit_points(sampling, 20, 3, 1));
    EXPECT_NE(unit_points(sampling, 20, 3, 1), unit_points(sampling, 20, 3, 2));
  }
}
// The samples of a Sobol design are the first samples of every larger design, so that computed results can be
// used again.
TEST(UnitPoints, OfSobolsSequenceStayWhenThereAreMore) {
  auto more = unit_points(Sampling::sobol, 64, 5, 9);
  more.resize(20);
  EXPECT_EQ(more, unit_points(Sampling::sobol, 20, 5, 9));
}
TEST(UnitPoints, LieInsideTheCube) {
  for (const Sampling sampling : {Sampling::latin_hypercube, Sampling::sobol})
    for (const auto& p : unit_points(sampling, 1000, 2, 5))
      for (const double x : p) EXPECT_TRUE(x > 0 && x < 1);
}
// The integral of the product of 4|x - 1/2| over the unit cube is 1. The error of a mean over Sobol's points
// falls almost as 1/n.
TEST(UnitPoints, OfSobolsSequenceIntegrateBetterThanChance) {
  double sum = 0;
  const auto points = unit_points(Sampling::sobol, 4096, 5, 1);
  for (const auto& p : points) {
    double product = 1;
    for (const double x : p) product *= std::abs(4 * x - 2);
    sum += product;
  }
  EXPECT_NEAR(sum / 4096, 1, 0.01);  // random points: standard deviation sqrt((4/3)^5 - 1)/64 = 0.028
}

}  // namespace
}  // namespace netloft::studies
