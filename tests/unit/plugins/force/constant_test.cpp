// SPDX-License-Identifier: BSD-3-Clause
//
// force/constant compared with values by hand.
#include "plugins/force/constant.hpp"

#include <gtest/gtest.h>

namespace {

using namespace netloft;
using forces::Constant;

TEST(ConstantForce, PullsWithItsPiecesAndDoesTheirWork) {
  State<1> s;
  s.x[0] = {2, -1, 5}, s.wants_tangent = true;
  Local<1> out;
  ASSERT_EQ(Constant::Pull::evaluate({10, -20, 4}, {0.5}, s, out), Status::ok);
  EXPECT_DOUBLE_EQ(out.force[0].x, -5);  // residual: minus the force
  EXPECT_DOUBLE_EQ(out.force[0].y, 10);
  EXPECT_DOUBLE_EQ(out.force[0].z, -2);
  EXPECT_DOUBLE_EQ(out.energy, -0.5 * (10 * 2 + 20 * 1 + 4 * 5));
}

TEST(ConstantForce, IsTheSameEverywhere) {
  State<1> here, there;
  there.x[0] = {-700, 3, 0.1};
  Local<1> a, b;
  Constant::Pull::evaluate({1, 2, 3}, {1}, here, a);
  Constant::Pull::evaluate({1, 2, 3}, {1}, there, b);
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(a.force[0][axis], b.force[0][axis]);
  for (const auto& row : b.tangent)
    for (const double entry : row) EXPECT_EQ(entry, 0);
}

TEST(ConstantForce, RefusesFewerThanNone) {
  EXPECT_THROW(Constant::check({}, {-1}), std::invalid_argument);
  EXPECT_NO_THROW(Constant::check({}, {0}));
}

}  // namespace
