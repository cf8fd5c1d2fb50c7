// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/scope.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace netloft::studies {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

ScopeRow row_of(const std::vector<std::array<double, 2>>& heel_and_spread) {
  ScopeRow row;
  for (std::size_t k = 0; k < heel_and_spread.size(); ++k)
    row.points.push_back({100 + 10 * static_cast<double>(k), heel_and_spread[k][0], heel_and_spread[k][1]});
  return row;
}

TEST(Scope, FindsTheLengthsBetweenWhichBoardsStandAsTheyOught) {
  ScopeRow row = row_of({{-15, 50}, {-5, 52}, {1, 54}, {4, 55}, {14, 56}});
  find_lengths({{}, {}, {-10, 9}, {}}, row);
  ASSERT_TRUE(row.warp && row.chosen);
  EXPECT_DOUBLE_EQ(row.warp->low, 105) << "-10 degrees lie half way";
  EXPECT_DOUBLE_EQ(row.warp->high, 135);
  EXPECT_EQ(*row.chosen, 2u) << "nearest to the middle of the band";
}

TEST(Scope, KeepsBothBands) {
  ScopeRow row = row_of({{-5, 40}, {0, 50}, {5, 60}});
  find_lengths({{}, {}, {-10, 10}, Interval{45, 55}}, row);
  ASSERT_TRUE(row.warp);
  EXPECT_DOUBLE_EQ(row.warp->low, 105);
  EXPECT_DOUBLE_EQ(row.warp->high, 115);
}

TEST(Scope, EndsWhereNothingIsKnownBeyond) {
  ScopeRow row = row_of({{kNone, kNone}, {2, 50}, {kNone, kNone}, {3, 50}});
  find_lengths({{}, {}, {0, 4}, {}}, row);
  ASSERT_TRUE(row.warp);
  EXPECT_EQ(row.warp->low, 110);
  EXPECT_EQ(row.warp->high, 110) << "the other side of a gap is another interval";
}

TEST(Scope, HasNoLengthWhereBoardsNeverStandSo) {
  ScopeRow row = row_of({{-20, 50}, {20, 52}});
  find_lengths({{}, {}, {-5, 5}, {}}, row);
  EXPECT_FALSE(row.warp || row.chosen);
}

}  // namespace
}  // namespace netloft::studies
