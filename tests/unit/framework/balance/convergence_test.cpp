// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace netloft::test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(Convergence, IsWithinTheToleranceOfTheLoad) {
  EXPECT_EQ(convergence_of({1e-4, 1000, 1e-9}, 1e-6), Convergence::within_tolerance);
  EXPECT_EQ(convergence_of({2e-3, 1000, 1e-9}, 1e-6), Convergence::none);
  EXPECT_EQ(convergence_of({0, 1000, 1e-9}, 0), Convergence::within_tolerance);
}

TEST(Convergence, IsAtRoundOffWhereRoundingIsSmallAgainstTheLoad) {
  EXPECT_EQ(convergence_of({2e-3, 1000, 5e-3}, 1e-6), Convergence::at_round_off);
  EXPECT_EQ(convergence_of({6e-3, 1000, 5e-3}, 1e-6), Convergence::none);
}

TEST(Convergence, IsNeverWhereRoundingIsNotSmallAgainstTheLoad) {
  for (const double residual : {0.0, 1e-12, 1e-3, 3.0, 3.89})
    EXPECT_EQ(convergence_of({residual, 3, 4}, 1e-6), Convergence::none) << residual;
}

TEST(Convergence, OfAStepInTimeIsNotKeptByTheRoundingOfItsInertia) {
  EXPECT_EQ(convergence_of({1e-9, 3, 4, true, true}, 1e-6), Convergence::within_tolerance);
  EXPECT_EQ(convergence_of({1e-3, 3, 4, true, true}, 1e-6), Convergence::at_round_off);
  EXPECT_EQ(convergence_of({1e-2, 3, 4, true, true}, 1e-6), Convergence::none);
}

TEST(Convergence, IsAtRestWhereNothingButRoundingLoads) {
  EXPECT_EQ(convergence_of({1e-9, 0, 1e-8, false}, 1e-6), Convergence::at_round_off);
  EXPECT_EQ(convergence_of({0, 0, 1e-8, false}, 1e-6), Convergence::within_tolerance);
  EXPECT_EQ(convergence_of({1e-7, 0, 1e-8, false}, 1e-6), Convergence::none);
}

TEST(Convergence, IsNotExcusedByWhatIsNoNumber) {
  EXPECT_EQ(convergence_of({1, kInfinite, 0}, 1e-6), Convergence::none);
  EXPECT_EQ(convergence_of({std::nan(""), 1, 0}, 1e-6), Convergence::none);
  EXPECT_EQ(convergence_of({0, 1, std::nan("")}, 1e-6), Convergence::none);
  EXPECT_EQ(convergence_of({0, std::nan(""), 0}, 1e-6), Convergence::none);
}

TEST(Convergence, AtRoundOffWaitsUntilTheResidualFallsNoMore) {
  EXPECT_FALSE(may_stop(Convergence::at_round_off, 1, 3));
  EXPECT_TRUE(may_stop(Convergence::at_round_off, 1, 1.5));
  EXPECT_TRUE(may_stop(Convergence::within_tolerance, 1, 3));
  EXPECT_FALSE(may_stop(Convergence::none, 1, 1));
}

TEST(Convergence, HasNothingToGainOnlyWhereNeitherResidualNorEnergyMatters) {
  EXPECT_TRUE(has_nothing_to_gain({0.5, 1000, 1e-9}, 9e-7, 10));
  EXPECT_FALSE(has_nothing_to_gain({0.5, 1000, 1e-9}, 2e-6, 10));
  EXPECT_FALSE(has_nothing_to_gain({2, 1000, 1e-9}, 0, 10));
  EXPECT_FALSE(has_nothing_to_gain({0.5, 1000, 2}, 0, 10)) << "rounding is not small";
}

}  // namespace
}  // namespace netloft::test
