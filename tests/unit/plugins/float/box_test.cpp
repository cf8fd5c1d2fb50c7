// SPDX-License-Identifier: BSD-3-Clause
//
// float/box compared with values by hand, and its tangents with differences.
#include "plugins/float/box.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace netloft;
using floats::Box;

constexpr Water kRoundWater{1000, 10};

Box::Parameters box() {
  Box::Parameters p;
  p.mass = 20, p.length_x = 0.4, p.length_y = 0.5, p.height = 0.25;
  p.drag_x = 1.2, p.drag_y = 1, p.drag_z = 0.8;
  return p;
}

State<1> at_height(double z) {
  State<1> s;
  s.x[0] = {1, 2, z}, s.water = kRoundWater, s.wants_tangent = true;
  return s;
}

double lift_at(const Box::Parameters& p, double z) {
  Local<1> out;
  Box::Buoyancy::evaluate(p, {1}, at_height(z), out);
  return -out.force[0].z;
}

TEST(Box, StandsOnItsNodeAndIsLiftedByWhatItImmerses) {
  const double per_metre = 1000 * 10 * 0.4 * 0.5;
  EXPECT_EQ(lift_at(box(), 0.01), 0);
  EXPECT_DOUBLE_EQ(lift_at(box(), -0.1), 0.1 * per_metre);
  EXPECT_DOUBLE_EQ(lift_at(box(), -3), 0.25 * per_metre);
}

TEST(Box, HangsBelowItsNode) {
  auto p = box();
  p.hangs = true;
  const double per_metre = 1000 * 10 * 0.4 * 0.5;
  EXPECT_EQ(lift_at(p, 0.26), 0);
  EXPECT_NEAR(lift_at(p, 0.1), 0.15 * per_metre, 1e-9);
  EXPECT_DOUBLE_EQ(lift_at(p, -0.01), 0.25 * per_metre);
}

TEST(Box, NeedsTheWorkOfItsBuoyancyToBePushedDown) {
  Local<1> below, above;
  Box::Buoyancy::evaluate(box(), {1}, at_height(-2), below);
  Box::Buoyancy::evaluate(box(), {1}, at_height(0.3), above);
  const double per_metre = 1000 * 10 * 0.4 * 0.5;
  EXPECT_NEAR(below.energy - above.energy, per_metre * (0.25 * 0.25 / 2 + 0.25 * (2 - 0.25)), 1e-9);
}

TEST(Box, WeighsItsMassInAir) {
  Local<1> out;
  Box::Weight::evaluate(box(), {0.5}, at_height(4), out);
  EXPECT_DOUBLE_EQ(out.force[0].z, 0.5 * 20 * 10);
  EXPECT_DOUBLE_EQ(out.energy, 0.5 * 20 * 10 * 4);
}

TEST(Box, DragsOnTheSidesThatAreImmersed) {
  State<1> s = at_height(-0.1);
  s.current[0] = {0.6, 0.8, 0};
  Local<1> out;
  Box::Drag::evaluate(box(), {1}, s, out);
  EXPECT_NEAR(-out.force[0].x, 0.5 * 1000 * 1.2 * 0.5 * 0.1 * 0.6, 1e-12);
  EXPECT_NEAR(-out.force[0].y, 0.5 * 1000 * 1.0 * 0.4 * 0.1 * 0.8, 1e-12);
  EXPECT_EQ(out.force[0].z, 0);
}

TEST(Box, HasTheDerivativeOfItsDragAsTangent) {
  State<1> s = at_height(-0.1);
  s.current[0] = {0.6, -0.3, 0.2}, s.v[0] = {0.1, 0.4, -0.5}, s.cu = 1, s.cv = 0;
  const auto force_at = [&](double z) {
    State<1> moved = s;
    moved.x[0].z = z;
    Local<1> out;
    Box::Drag::evaluate(box(), {1}, moved, out);
    return out.force[0];
  };
  Local<1> out;
  Box::Drag::evaluate(box(), {1}, s, out);
  const Vec3<double> slope = (1 / 0.02) * (force_at(-0.09) - force_at(-0.11));  // linear in z
  for (int r = 0; r < 3; ++r) EXPECT_NEAR(out.tangent[r][2], slope[r], 1e-9 * std::abs(slope[r]));
}

TEST(Box, RefusesFewerThanNone) {
  EXPECT_THROW(Box::check({}, {-1}), std::invalid_argument);
  EXPECT_NO_THROW(Box::check({}, {0}));
}

}  // namespace
