// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/perturbed.hpp"

#include <gtest/gtest.h>

namespace netloft::real_gears {
namespace {

TEST(PerturbedDrawings, BeginWithThePlainOneAndGrowByEqualRatios) {
  const auto starts = starts_of({.count = 3, .least = 1e-3, .largest = 0.1, .seed = 7});
  ASSERT_EQ(starts.size(), 4u);
  EXPECT_EQ(starts[0].noise, 0);
  EXPECT_DOUBLE_EQ(starts[1].noise, 1e-3);
  EXPECT_DOUBLE_EQ(starts[2].noise, 1e-2);
  EXPECT_DOUBLE_EQ(starts[3].noise, 0.1);
  EXPECT_NE(starts[1].seed, starts[2].seed);
}

TEST(PerturbedDrawings, MedianAndNinetyFivePercentAreOfAllRuns) {
  std::vector<Effort> efforts;
  for (int f = 20; f >= 1; --f) efforts.push_back({f != 20, f});  // the most expensive run did not converge
  const Reliability r = summarise(efforts);
  EXPECT_EQ(r.runs, 20u);
  EXPECT_EQ(r.converged, 19u);
  EXPECT_EQ(r.median, 10);
  EXPECT_EQ(r.most_of_them, 19);
}

TEST(PerturbedDrawings, OneRunIsItsOwnMedian) {
  const Reliability r = summarise({{true, 42}});
  EXPECT_EQ(r.median, 42);
  EXPECT_EQ(r.most_of_them, 42);
}

}  // namespace
}  // namespace netloft::real_gears
