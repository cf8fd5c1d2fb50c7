// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/svg/log_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace netloft::formats {
namespace {

LogAxis axis(std::vector<double> values, int most_labels = 6) { return LogAxis(values, most_labels); }

std::vector<double> labels(const LogAxis& a) {
  std::vector<double> all;
  for (const auto& tick : a.ticks())
    if (tick.labelled) all.push_back(tick.value);
  return all;
}

TEST(LogAxis, HoldsAllValuesWithRoomToSpare) {
  const LogAxis a = axis({3e-4, 0.1, 40});
  EXPECT_DOUBLE_EQ(a.low(), 2e-4);  // an axis that ends at 3e-4 would end too near to the value
  EXPECT_DOUBLE_EQ(a.high(), 50);
  const LogAxis round = axis({1e-3, 1e2});  // values at powers of ten also keep a distance from the ends
  EXPECT_DOUBLE_EQ(round.low(), 8e-4);
  EXPECT_DOUBLE_EQ(round.high(), 200);
}

TEST(LogAxis, PutsEveryDecadeAtTheSameDistance) {
  const LogAxis a = axis({2e-3, 8});
  EXPECT_DOUBLE_EQ(a.place(a.low()), 0);
  EXPECT_DOUBLE_EQ(a.place(a.high()), 1);
  EXPECT_NEAR(a.place(1) - a.place(0.1), a.place(0.1) - a.place(0.01), 1e-15);
}

TEST(LogAxis, LabelsPowersOfTen) {
  EXPECT_EQ(labels(axis({3e-4, 40})), (std::vector<double>{1e-3, 1e-2, 1e-1, 1, 10}));
}

TEST(LogAxis, LabelsFewerOfManyDecades) {
  const auto some = labels(axis({1e-13, 1}));
  EXPECT_LE(some.size(), 6u);
  ASSERT_GE(some.size(), 4u);
  for (std::size_t i = 1; i < some.size(); ++i) EXPECT_NEAR(some[i] / some[i - 1], 1e3, 1e-6);
}

TEST(LogAxis, LabelsTwoAndFiveWithinADecade) {
  const auto few = labels(axis({0.12, 0.4}));
  EXPECT_EQ(few, (std::vector<double>{0.1, 0.2, 0.5}));
}

TEST(LogAxis, DividesDecadesWhileThereIsRoom) {
  EXPECT_EQ(axis({2e-2, 40}).ticks().size(), 9u * 3 + 5);  // 0.01, 0.02 … 9, 10 … 50
  EXPECT_EQ(axis({1e-12, 1}).ticks().size(), 13u);
}

TEST(LogAxis, IsAnAxisWhateverItIsGiven) {
  const double infinity = std::numeric_limits<double>::infinity(), none = std::nan("");
  for (const auto& values : {std::vector<double>{}, {0, -1, none, infinity}, {7, 7}, {1e-300, 1e300}}) {
    const LogAxis a = axis(values);
    EXPECT_LT(a.low(), a.high());
    EXPECT_TRUE(std::isfinite(a.high() / a.low()) || values.size() == 2);
    EXPECT_GE(labels(a).size(), 1u);
  }
}

}  // namespace
}  // namespace netloft::formats
