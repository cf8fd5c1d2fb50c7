// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/text/measured.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::results {
namespace {

TEST(Measured, IsRoundedToTheFirstDigitOfItsError) {
  EXPECT_EQ(measured(0.412556, 0.064), "0.41 ± 0.06");
  EXPECT_EQ(measured(11071.2, 234.0), "11100 ± 200");
  EXPECT_EQ(measured(-2.9573, 0.0002), "-2.9573 ± 0.0002");
}

TEST(Measured, KeepsTheSecondDigitOfAnErrorThatBeginsWithOne) {
  EXPECT_EQ(measured(0.412556, 0.0123), "0.413 ± 0.012");
  EXPECT_EQ(measured(6455.0, 1830.0), "6500 ± 1800");
}

TEST(Measured, IsPlainWithoutAKnownError) {
  EXPECT_EQ(measured(0.412556, std::nan("")), "0.412556");
  EXPECT_EQ(measured(0.412556, 1e-12), "0.412556");
  EXPECT_EQ(measured(std::nan(""), 0.1), "-");
}

TEST(Measured, HasNoSignWhereItRoundsToZero) { EXPECT_EQ(measured(-0.001, 0.3), "0.0 ± 0.3"); }

}  // namespace
}  // namespace netloft::results
