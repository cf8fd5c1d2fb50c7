// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/step_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

/// A scheme whose error in a step is of third order, and which is stable with steps of any length.
IntegratorType third_order() {
  IntegratorType type;
  type.type = "third/order";
  type.integrator.order = [](const void*) -> double { return 3; };
  type.integrator.stable_step = [](const void*, double) -> double { return 0; };
  return type;
}

struct Controlled {
  MarchSettings settings;
  IntegratorType type = third_order();
  StepScheme scheme{{&type, nullptr}};
  StepControl control{settings, scheme, 2};  // the longest element has 2 m
};

TEST(StepControl, AllowsAStepWhatItMustForThePathToBeAsAccurateAsIsAsked) {
  Controlled c;
  c.settings.accuracy = 0.05;
  EXPECT_DOUBLE_EQ(c.control.allowed(), 0.05) << "coarse paths are held to the error of a step";
  c.settings.accuracy = 1e-4;
  EXPECT_DOUBLE_EQ(c.control.allowed(), 1e-6) << "(2): 1e-2 (1e-4/1e-2)²";
  EXPECT_DOUBLE_EQ(c.control.tolerated(), 2e-6);
}

TEST(StepControl, LengthensAStepByItsErrorAndNoMoreThanTwice) {
  Controlled c;
  EXPECT_DOUBLE_EQ(c.control.next_step(1, 0.125), 1.8) << "(1): 0.9 · 8^(1/3)";
  EXPECT_DOUBLE_EQ(c.control.next_step(1, 1e-9), 2);
  c.settings.longest_step = 1.5;
  EXPECT_DOUBLE_EQ(c.control.next_step(1, 0.125), 1.5);
}

TEST(StepControl, ShortensAStepByItsErrorAndNoMoreThanToAFifth) {
  Controlled c;
  EXPECT_DOUBLE_EQ(c.control.shorter_step(1, 8), 0.45);
  EXPECT_DOUBLE_EQ(c.control.shorter_step(1, 1e6), 0.2);
}

}  // namespace
}  // namespace netloft
