// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/packed_array.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace netloft::pictures {
namespace {

TEST(RoundedToShown, IsNearerThanFourDigits) {
  for (const double value : {1.2345678, -9.9999999e9, 1e-20, 0.1, 7.0, 123456.789})
    EXPECT_NEAR(rounded_to_shown(value), value, std::abs(value) * std::exp2(-kShownBits)) << value;
}

TEST(RoundedToShown, KeepsWhatIsNoNumberAndZero) {
  EXPECT_TRUE(std::isnan(rounded_to_shown(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(rounded_to_shown(-INFINITY), -INFINITY);
  EXPECT_EQ(rounded_to_shown(0), 0);
}

TEST(RoundedToShown, MakesArraysSmaller) {
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i) values.push_back(std::sin(i * 12.9898));
  const auto size = [](const nlohmann::ordered_json& array) { return array["d"].get<std::string>().size(); };
  EXPECT_LT(size(packed_as_shown(values)), 0.75 * size(packed(values)));
}

}  // namespace
}  // namespace netloft::pictures
