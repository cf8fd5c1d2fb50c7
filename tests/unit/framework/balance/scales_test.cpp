// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/scales.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

/// Two bars of 0.5 kg/m in a vacuum, one below the other, which extend over 3 m and 2 m in height. The top is
/// fixed, and a load of `load` newtons acts at the lower end.
Assembled two_bars(double load, double gravity) {
  Sketch s;
  s.scene.water = {0, gravity};
  const auto top = s.node(0, 0, 0, kAllAxes), middle = s.node(1, 0, -3), end = s.node(1, 0.5, -5);
  Part& bars = s.rope("bars", {top, middle, end}, 4);
  bars.parameters["rope.diameter"] = 0.1, bars.parameters["rope.density"] = 200 / std::numbers::pi;
  if (load != 0) s.part("load", "test/load", {{"z", load}}, {end});
  return Assembled(s.scene);
}

TEST(Scales, HaveTheLongestExtentOfAnElementAlongAnAxis) {
  Assembled a = two_bars(0, 0);
  EXPECT_EQ(Scales(a.assembler).element_size(), 3);
}

TEST(Scales, TakeTheLargestNodalSumOfConstantForcesForTheLoad) {
  Assembled a = two_bars(-500, 0);
  Scales scales(a.assembler);
  EXPECT_EQ(scales.dead_load(), 500);
  EXPECT_EQ(scales.driving_load().largest, 500);
  EXPECT_EQ(scales.driving_load().sum, 500);
}

// Each node carries half of the weight of each of its bars: 0.5 kg/m · 4 m · 10 m/s² per bar.
TEST(Scales, CountTheWeightAtAllNodes) {
  Assembled a = two_bars(0, 10);
  EXPECT_NEAR(Scales(a.assembler).driving_load().largest, 20, 1e-12);
  EXPECT_NEAR(Scales(a.assembler).driving_load().sum, 30, 1e-12);
}

TEST(Scales, FindThatElementsAloneDriveNothing) {
  Assembled alone = two_bars(0, 0), loaded = two_bars(-1, 0);
  EXPECT_FALSE(Scales(alone.assembler).is_driven(alone.assembler.start()));
  EXPECT_TRUE(Scales(loaded.assembler).is_driven(loaded.assembler.start()));
}

}  // namespace
}  // namespace netloft::test
