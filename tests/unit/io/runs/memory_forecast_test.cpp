// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/memory_forecast.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace netloft::runs {
namespace {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define NETLOFT_HAS_SHADOW
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define NETLOFT_HAS_SHADOW
#endif
#ifdef NETLOFT_HAS_SHADOW
constexpr bool kHasShadow = true;
#else
constexpr bool kHasShadow = false;
#endif

TEST(MemoryWithinReach, IsNoMoreThanTheLimitOfAddresses) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  const double free = memory_within_reach();
  EXPECT_GT(free, 0x1p24);
  if (kHasShadow) GTEST_SKIP() << "the shadow of a sanitizer wants terabytes of addresses";
  rlimit tight = before;
  tight.rlim_cur = rlim_t{1} << 34;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &tight), 0);
  const double limited = memory_within_reach();
  ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
  EXPECT_LE(limited, 0x1p34);
  EXPECT_GT(limited, 0x1p24);
}

}  // namespace
}  // namespace netloft::runs
