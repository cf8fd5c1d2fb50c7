// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/march_times.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

MarchSettings of(double duration, double interval, bool dense = false) {
  MarchSettings s;
  s.duration = duration, s.output_interval = interval, s.dense = dense;
  return s;
}

TEST(MarchTimes, HaveOutputsAtTheBeginningEachIntervalAndTheEnd) {
  const MarchSettings settings = of(1, 0.4);
  const MarchTimes times(settings, {});
  ASSERT_EQ(times.output_count(), 4u);
  EXPECT_EQ(times.output(0), 0);
  EXPECT_EQ(times.output(2), 0.8);
  EXPECT_EQ(times.output(3), 1) << "the end, though no whole interval is over";
}

TEST(MarchTimes, HaveTheBeginningAndTheEndWhereNoIntervalIsGiven) {
  const MarchSettings settings = of(3, 0);
  const MarchTimes times(settings, {});
  ASSERT_EQ(times.output_count(), 2u);
  EXPECT_EQ(times.output(1), 3);
}

TEST(MarchTimes, EndStepsAtCornersAndOutputs) {
  const MarchSettings settings = of(1, 0.5);
  const MarchTimes times(settings, {0.7});
  EXPECT_EQ(times.next_corner(0), 0.5);
  EXPECT_EQ(times.next_corner(0.5), 0.7);
  EXPECT_EQ(times.next_corner(0.7), 1);
}

TEST(MarchTimes, EndStepsAtNoOutputThatLiesBetweenThem) {
  const MarchSettings settings = of(1, 0.5, true);
  EXPECT_EQ(MarchTimes(settings, {0.7}).next_corner(0), 0.7);
}

TEST(MarchTimes, TakeNoCornerThatRoundingHasLeft) {
  const MarchSettings settings = of(1, 0);
  const MarchTimes times(settings, {0.3, 0.6});
  EXPECT_EQ(times.next_corner(std::nextafter(0.3, 0)), 0.6);
}

TEST(MarchTimes, KnowOutputsOfAMarchWithAnotherInterval) {
  const MarchSettings settings = of(1, 0.2);
  const MarchTimes times(settings, {});
  EXPECT_TRUE(times.is_output(3 * 0.2)) << "but for rounding";
  EXPECT_FALSE(times.is_output(0.5));
  EXPECT_TRUE(times.is_output(1));
}

}  // namespace
}  // namespace netloft
