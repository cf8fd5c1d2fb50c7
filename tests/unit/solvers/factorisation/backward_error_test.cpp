// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/backward_error.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace netloft {
namespace {

// |4 2; 2 5| with the lower triangle given, x = (1, 1), b = (7, 7): r = (1, 0), s = (13, 14).
TEST(BackwardError, IsThatOfOettliAndPrager) {
  const std::vector<int> row{1, 2, 2}, column{1, 1, 2};
  const std::vector<double> value{4, 2, 5}, x{1, 1}, b{7, 7};
  std::vector<double> r(2), s(2);
  EXPECT_DOUBLE_EQ(find_backward_error({row, column, value, true}, x, b, r, s), 1.0 / 13);
  EXPECT_EQ(r, (std::vector<double>{1, 0}));
  EXPECT_EQ(s, (std::vector<double>{13, 14}));
  // Without the entry above the diagonal: r = (3, 0), s = (11, 14).
  EXPECT_DOUBLE_EQ(find_backward_error({row, column, value, false}, x, b, r, s), 3.0 / 11);
}

TEST(BackwardError, IsInfiniteWhereANumberIsNotFinite) {
  const std::vector<int> one{1};
  const std::vector<double> value{4}, b{1};
  std::vector<double> r(1), s(1);
  const std::vector<double> x{std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(find_backward_error({one, one, value, true}, x, b, r, s),
            std::numeric_limits<double>::infinity());
}

TEST(BackwardError, OfNothingIsZero) { EXPECT_EQ(find_backward_error({}, {}, {}, {}, {}), 0); }

}  // namespace
}  // namespace netloft
