// SPDX-License-Identifier: BSD-3-Clause
#include "io/case/memory_forecast.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace netloft::io {
namespace {

TEST(MemoryWithinReach, IsNoMoreThanTheLimitOfAddresses) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  const double free = memory_within_reach();
  EXPECT_GT(free, 0x1p24);
  rlimit tight = before;
  tight.rlim_cur = rlim_t{1} << 34;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &tight), 0);
  const double limited = memory_within_reach();
  ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
  EXPECT_LE(limited, 0x1p34);
  EXPECT_GT(limited, 0x1p24);
}

}  // namespace
}  // namespace netloft::io
