// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/workers.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace netloft {
namespace {

TEST(Workers, CallEveryIndexOnce) {
  Workers workers(3);
  ASSERT_EQ(workers.size(), 3u);
  for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u}) {
    std::vector<int> calls(count, 0);
    workers.run(count, 2, [&](std::size_t worker, std::size_t i) {
      ASSERT_LT(worker, 3u);
      ++calls[i];
    });
    EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), 0), static_cast<int>(count));
    for (const int c : calls) EXPECT_EQ(c, 1);
  }
}

TEST(Workers, SeeInOneLoopWhatTheLoopBeforeWrote) {
  Workers workers(3);
  constexpr std::size_t kCount = 64;
  std::vector<long> values(kCount, 0);
  for (int loop = 0; loop < 5000; ++loop)
    workers.run(kCount, 2, [&](std::size_t, std::size_t i) { values[(i + 1) % kCount] += 1; });
  for (const long v : values) EXPECT_EQ(v, 5000);
}

TEST(Workers, StayWithTheCallerWhenThereIsLittleToDo) {
  Workers workers(3);
  workers.run(7, 8, [&](std::size_t worker, std::size_t) { EXPECT_EQ(worker, 0u); });
}

TEST(Workers, EndWithoutHavingWorked) { Workers workers(4); }

}  // namespace
}  // namespace netloft
