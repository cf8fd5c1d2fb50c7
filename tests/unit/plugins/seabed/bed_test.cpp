// SPDX-License-Identifier: BSD-3-Clause
//
// seabed/bed: on a plane it is seabed/plane; on a hill it presses along the normal of the hill; friction has
// its size.
#include "plugins/seabed/bed.hpp"

#include "tests/unit/plugins/kernel_oracle.hpp"

namespace {

using namespace netloft;
using seabed::OnBed;
using seabed::Plane;

constexpr double kSoft = 0.02;

OnBed::Parameters firm() { return {.stiffness = 3e4, .softness = kSoft, .friction = 0.6, .radius = 0}; }

/// A bed with slopes and curvature below the origin.
Bed hill(double height) {
  return {.is_there = true,
          .height = height,
          .slope_x = 0.2,
          .slope_y = -0.1,
          .xx = 0.03,
          .xy = 0.01,
          .yy = -0.02};
}

State<1> node_over(const Bed& bed, double z) {
  State<1> s;
  s.bed[0] = bed, s.x[0] = {0, 0, z};
  return s;
}

TEST(SeabedBed, PressesAsAPlaneWhereItIsLevel) {
  Plane::Parameters plane;
  plane.depth = 0, plane.stiffness = 3e4, plane.softness = kSoft;
  for (const double z : {-0.005, -0.015, -0.1, 0.05}) {
    const State<1> s = node_over({.is_there = true}, z);
    EXPECT_NEAR(OnBed::normal_force(firm(), {2, 0}, s), Plane::normal_force(plane, {2, 0}, s), 1e-9) << z;
  }
}

TEST(SeabedBed, PushesAlongItsNormalAndStiffensWhereItIsHollow) {
  Local<1> out;
  const State<1> s = node_over(hill(-40), -40.1);
  ASSERT_EQ(OnBed::Contact::evaluate(firm(), {2, 0}, s, out), Status::ok);
  const double push = 2 * 3e4 * (0.1 - kSoft / 2);
  EXPECT_NEAR(out.force[0].z, -push, 1e-9);  // of the residual, hence downwards
  EXPECT_NEAR(out.force[0].x, 0.2 * push, 1e-9);
  EXPECT_NEAR(out.force[0].y, -0.1 * push, 1e-9);
  EXPECT_NEAR(out.tangent[2][2], 6e4, 1e-9);
  EXPECT_NEAR(out.tangent[0][0], 6e4 * 0.04 + push * 0.03, 1e-9);
}

TEST(SeabedBed, LiesDeeperUnderBobbins) {
  OnBed::Parameters p = firm();
  p.radius = 0.25;
  EXPECT_EQ(OnBed::normal_force(p, {2, 0}, node_over(hill(-40), -39.74)), 0);
  EXPECT_GT(OnBed::normal_force(p, {2, 0}, node_over(hill(-40), -39.80)), 0);
}

TEST(SeabedBed, RubsByItsShareOfTheNormalForceAlongTheGroundThatPasses) {
  const State<1> s = node_over(hill(-40), -40.1);
  MovingNodes<double, 1> m;
  m.x[0] = s.x[0], m.bed[0] = s.bed[0], m.ground = {1.5, 0, 0};
  const Vec3<double> rub = OnBed::Friction::force(firm(), {2, 0}, m)[0];
  EXPECT_NEAR(norm(rub), 0.6 * OnBed::normal_force(firm(), {2, 0}, s), 1e-9);
  EXPECT_NEAR(dot(rub, {-0.2, 0.1, 1}), 0, 1e-9) << "along the hill";
  EXPECT_GT(rub.x, 0) << "aft, with the ground";
  m.ground = {};
  EXPECT_EQ(norm(OnBed::Friction::force(firm(), {2, 0}, m)[0]), 0) << "what stands does not rub";
}

TEST(SeabedBed, IsNothingWhereTheSceneHasNone) {
  Local<1> out;
  ASSERT_EQ(OnBed::Contact::evaluate(firm(), {2, 0}, node_over({}, -1e4), out), Status::ok);
  EXPECT_EQ(out.energy, 0);
}

}  // namespace
