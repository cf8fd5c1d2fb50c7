// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/study_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace netloft::studies {
namespace {

// In R, quantile(c(7, 1, 3, 10), c(0, .05, .25, .5, .9, 1)) gives 1.0 1.3 2.5 5.0 9.1 10.0.
TEST(Statistics, HaveTheQuantilesOfR) {
  const std::vector<double> sample{7, 1, 3, 10};
  const double expected[][2] = {{0, 1}, {0.05, 1.3}, {0.25, 2.5}, {0.5, 5}, {0.9, 9.1}, {1, 10}};
  for (const auto& [p, q] : expected) EXPECT_NEAR(quantile_of(sample, p), q, 1e-12);
}
TEST(Statistics, LeaveOutWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(quantile_of({nan, 4, nan}, 0.5), 4);
  EXPECT_TRUE(std::isnan(quantile_of({nan}, 0.5)));
  EXPECT_TRUE(std::isnan(quantile_of({}, 0.5)));
}
TEST(Statistics, HaveMeanAndDeviation) {
  EXPECT_DOUBLE_EQ(mean_of({2, 4, 4, 4, 5, 5, 7, 9}), 5);
  EXPECT_NEAR(deviation_of({2, 4, 4, 4, 5, 5, 7, 9}), std::sqrt(32.0 / 7), 1e-12);
  EXPECT_EQ(deviation_of({3}), 0);
}

}  // namespace
}  // namespace netloft::studies
