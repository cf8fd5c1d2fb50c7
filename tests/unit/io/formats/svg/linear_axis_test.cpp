// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/svg/linear_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace netloft::formats {
namespace {

std::vector<double> ticks_of(const LinearAxis& axis) {
  std::vector<double> values;
  for (const auto& tick : axis.ticks()) values.push_back(tick.value);
  return values;
}

TEST(LinearAxis, HoldsAllValuesWithAMargin) {
  const std::vector<double> values{2, 5, 3};
  const LinearAxis axis(values);
  EXPECT_LT(axis.low(), 2);
  EXPECT_GT(axis.high(), 5);
  EXPECT_DOUBLE_EQ(axis.place(axis.low()), 0);
  EXPECT_DOUBLE_EQ(axis.place((axis.low() + axis.high()) / 2), 0.5);
}
TEST(LinearAxis, HasTicksAtRoundNumbers) {
  const std::vector<double> values{0.1, 0.92};
  const auto ticks = ticks_of(LinearAxis(values, 5));
  ASSERT_EQ(ticks.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(ticks[i], 0.2 * static_cast<double>(i + 1), 1e-12);
}
TEST(LinearAxis, HasRoomForASingleValueAndForNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<double>& values : {std::vector<double>{1000}, {0}, {-3, -3}, {nan}, {}}) {
    const LinearAxis axis(values);
    EXPECT_LT(axis.low(), axis.high());
    EXPECT_GE(axis.ticks().size(), 2u);
    for (const double v : values)
      if (std::isfinite(v)) EXPECT_NEAR(axis.place(v), 0.5, 1e-9);
  }
  EXPECT_FALSE(LinearAxis({}).has_place(nan));
}
TEST(LinearAxis, HasNoMoreLabelsThanFit) {
  for (double high = 1; high < 1e7; high *= 1.7)
    for (const int most : {3, 7}) {
      const std::vector<double> values{-0.3 * high, high};
      const auto count = LinearAxis(values, most).ticks().size();
      EXPECT_GE(count, 1u);
      EXPECT_LE(count, static_cast<std::size_t>(most) + 1);
    }
}

}  // namespace
}  // namespace netloft::formats
