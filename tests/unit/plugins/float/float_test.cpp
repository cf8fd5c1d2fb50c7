// SPDX-License-Identifier: BSD-3-Clause
//
// float/float compared with values by hand, and its drag tangent with dual numbers.
#include "plugins/float/float.hpp"
#include "plugins/common/sphere.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace netloft;
using floats::Float;

constexpr Water kWater{1025, 9.81};

State<1> somewhere() {
  State<1> s;
  s.x[0] = {3, -2, -20}, s.v[0] = {0.2, -0.4, 0.1}, s.a[0] = {0.5, 1, -2};
  s.current[0] = {1.5, 0.3, 0}, s.current_dz[0] = {0.02, -0.01, 0.003};
  s.water = kWater;
  s.wants_tangent = true;
  return s;
}

TEST(Float, LiftsByItsShareOfTheGivenBuoyancy) {
  Float::Parameters p;
  p.buoyancy = 24.6, p.volume = 99, p.mass = 1;  // a given buoyancy overrides volume and mass
  Local<1> out;
  ASSERT_EQ(Float::Buoyancy::evaluate(p, {2.5}, somewhere(), out), Status::ok);
  EXPECT_DOUBLE_EQ(out.force[0].z, -61.5);  // residual: minus the force
  EXPECT_DOUBLE_EQ(out.energy, 61.5 * 20);
}

TEST(Float, LiftsWithTheWaterItDisplacesLessItsWeight) {
  Float::Parameters p;
  p.volume = 0.004, p.mass = 1.5;
  EXPECT_NEAR(Float::net_buoyancy(p, kWater), (1025 * 0.004 - 1.5) * 9.81, 1e-12);
}

TEST(Float, SinksWhenItsBuoyancyIsNegative) {
  Float::Parameters p;
  p.buoyancy = -100;
  Local<1> out;
  Float::Buoyancy::evaluate(p, {1}, somewhere(), out);
  EXPECT_DOUBLE_EQ(out.force[0].z, 100);
}

TEST(Float, DragsWithTheSquareOfTheFlowOnTheCircleOfItsDiameter) {
  Float::Parameters p;
  p.diameter = 0.2, p.drag_coefficient = 0.5;
  State<1> s;
  s.water = kWater, s.current[0] = {2, 0, 0};
  Local<1> out;
  Float::Drag::evaluate(p, {1}, s, out);
  EXPECT_NEAR(out.force[0].x, -0.5 * 1025 * 0.5 * std::acos(-1.0) / 4 * 0.04 * 4, 1e-10);
  p.area = 1;
  EXPECT_DOUBLE_EQ(Float::drag_factor(p, kWater), 0.5 * 1025);
}

/// Equation (3) in dual numbers, with W = c(z) - v; the variables are the position (0 … 2) and the velocity
/// (3 … 5).
Vec3<Dual<6>> drag_oracle(double factor, const State<1>& s) {
  Vec3<Dual<6>> W;
  const auto z = Dual<6>::variable(0, 2);
  for (int axis = 0; axis < 3; ++axis)
    W[axis] = s.current[0][axis] + z * s.current_dz[0][axis] - Dual<6>::variable(s.v[0][axis], 3 + axis);
  return (-factor) * (norm(W) * W);
}

TEST(Float, HasTheDerivativeOfItsDragAsTangent) {
  Float::Parameters p;
  p.area = 0.3, p.drag_coefficient = 0.47;
  State<1> s = somewhere();
  const auto want = drag_oracle(1.7 * 0.47 * Float::drag_factor(p, kWater), s);
  s.cu = 0.7, s.cv = 1.3;
  Local<1> out;
  ASSERT_EQ(Float::Drag::evaluate(p, {1.7}, s, out), Status::ok);
  for (int r = 0; r < 3; ++r) {
    EXPECT_NEAR(out.force[0][r], want[r].value, 1e-12 * std::abs(want[r].value));
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(out.tangent[r][c], 0.7 * want[r].gradient[c] + 1.3 * want[r].gradient[3 + c], 1e-9)
          << r << c;
  }
}

// Smooth spheres: H. Schlichting, Boundary-Layer Theory, fig. 1.5; R. Clift, J. R. Grace and M. E. Weber,
// Bubbles, Drops, and Particles, 1978, table 5.2.
TEST(Float, HasTheDragOfASphereOnBothSidesOfItsCrisis) {
  EXPECT_NEAR(sphere_drag(1e-2), 2400, 30);  // Stokes
  EXPECT_NEAR(sphere_drag(100.0), 1.09, 0.06);
  EXPECT_NEAR(sphere_drag(1e4), 0.40, 0.03);
  EXPECT_NEAR(sphere_drag(1e5), 0.48, 0.06);
  EXPECT_LT(sphere_drag(4e5), 0.15);
}

TEST(Float, HasTheDerivativeOfTheDragOfASphereAsTangent) {
  Float::Parameters p;
  p.diameter = 0.2, p.drag_law = Float::kSphere;
  for (const double speed : {1e-4, 0.01, 0.5, 1.4, 1.7, 3.0}) {  // Re = 17 … 5e5
    State<1> s = somewhere();
    s.water.viscosity = 1.19e-6, s.v[0] = s.current[0] - Vec3<double>{0.6 * speed, 0, 0.8 * speed};
    s.cu = 0, s.cv = 1, s.wants_tangent = true;
    Local<1> out;
    ASSERT_EQ(Float::Drag::evaluate(p, {1}, s, out), Status::ok);
    const double h = 1e-6 * speed;
    for (int c = 0; c < 3; ++c) {
      Local<1> more, less;
      State<1> moved = s;
      moved.v[0][c] += h, Float::Drag::evaluate(p, {1}, moved, more);
      moved.v[0][c] -= 2 * h, Float::Drag::evaluate(p, {1}, moved, less);
      for (int r = 0; r < 3; ++r) {
        const double slope = (more.force[0][r] - less.force[0][r]) / (2 * h);
        EXPECT_NEAR(out.tangent[r][c], slope, 1e-6 * std::abs(out.tangent[2][2])) << speed << r << c;
      }
    }
  }
}

TEST(Float, RefusesASphereOfNoSize) {
  Float::Parameters p;
  p.drag_law = Float::kSphere;
  EXPECT_THROW(Float::check(p, {1}), std::invalid_argument);
}

TEST(Float, HasNoDragAndAFiniteTangentInWaterThatMovesAlong) {
  Float::Parameters p;
  p.area = 1, p.drag_coefficient = 1;
  State<1> s = somewhere();
  s.v[0] = s.current[0];
  Local<1> out;
  ASSERT_EQ(Float::Drag::evaluate(p, {1}, s, out), Status::ok);
  for (int r = 0; r < 3; ++r) {
    EXPECT_EQ(out.force[0][r], 0);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(out.tangent[r][c], 0);
  }
}

TEST(Float, MovesWaterAlongWhenItAccelerates) {
  Float::Parameters p;
  p.mass = 2, p.volume = 0.004, p.added_mass = 0.5;
  State<1> s = somewhere();
  s.ca = 0.9;
  Local<1> out;
  Float::Inertia::evaluate(p, {3}, s, out);
  const double mass = 3 * (2 + 0.5 * 1025 * 0.004);
  EXPECT_NEAR(out.force[0].y, mass * 1, 1e-12);
  EXPECT_NEAR(out.tangent[2][2], 0.9 * mass, 1e-12);
}

TEST(Float, RefusesFewerThanNone) {
  EXPECT_THROW(Float::check({}, {-1}), std::invalid_argument);
  EXPECT_NO_THROW(Float::check({}, {0}));
}

}  // namespace
