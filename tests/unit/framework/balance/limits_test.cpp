// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/limits.hpp"

#include <gtest/gtest.h>

namespace netloft {
namespace {

TEST(Limits, AreReachedOneByOne) {
  const WorkModel model{.factorisation = 1};
  const Limits limits{.iterations = 10, .seconds = 5, .model = &model, .work = 3};
  const auto after = [&](int iterations, double seconds, int factorisations) {
    return limits.reached(iterations, seconds, {.factorisations = factorisations});
  };
  EXPECT_EQ(after(9, 4.9, 2), Stop::none);
  EXPECT_EQ(after(10, 4.9, 2), Stop::iterations);
  EXPECT_EQ(after(9, 5, 2), Stop::time);
  EXPECT_EQ(after(9, 4.9, 3), Stop::work);
}

TEST(Limits, LetSomebodyInterruptBeforeAllElse) {
  std::atomic<bool> interrupt = true;
  const Limits limits{.iterations = 0, .interrupt = &interrupt};
  EXPECT_EQ(limits.reached(1, 0, {}), Stop::interrupted);
  interrupt = false;
  EXPECT_EQ(limits.reached(1, 0, {}), Stop::iterations);
}

}  // namespace
}  // namespace netloft
