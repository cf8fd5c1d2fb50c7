// SPDX-License-Identifier: BSD-3-Clause
//
// catch/pressure by hand, against the volume that it presses out, and its tangent against dual numbers.
#include "plugins/catch/pressure.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace {

using namespace netloft;
using catches::Pressure;

constexpr Water kWater{1025, 9.81};

Pressure::Parameters full(double pressure) {
  Pressure::Parameters p;
  p.pressure = pressure, p.meshes = 1e6;
  return p;
}

State<3> somewhere() {
  State<3> s;
  s.x = {{{0.3, -0.2, 1}, {1.4, 0.1, 1.2}, {0.5, 0.9, 0.4}}};
  s.water = kWater;
  s.wants_tangent = true;
  return s;
}

TEST(CatchPressure, PushesATriangleTowardsTheSideThatSeesItCounterClockwise) {
  State<3> s;
  s.x = {{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}};
  Local<3> out;
  ASSERT_EQ(Pressure::Push::evaluate(full(100), {}, s, out), Status::ok);
  for (const auto& r : out.force) {
    EXPECT_DOUBLE_EQ(r.z, -100 * 3.0 / 3);  // residual: minus a third of 100 Pa on 3 m²
    EXPECT_EQ(r.x, 0);
    EXPECT_EQ(r.y, 0);
  }
}

TEST(CatchPressure, IsThatOfTheFlowTheCatchStops) {
  Pressure::Parameters p;
  p.speed = 1.5, p.drag_coefficient = 1.4, p.meshes = 1;
  EXPECT_NEAR(Pressure::on(p, {{0, 0, 0}}, kWater), 1614.375, 1e-10);  // 1.4 × ½ × 1025 × 1.5²
}

TEST(CatchPressure, CountsThePartOfATriangleBehindTheFront) {
  const std::array<double, 3> s{2, 4, 1};  // corners in any order
  EXPECT_EQ(Pressure::share_behind_front(s, 1), 0);
  EXPECT_EQ(Pressure::share_behind_front(s, 4), 1);
  EXPECT_NEAR(Pressure::share_behind_front(s, 2), 1.0 / 3, 1e-15);      // (2-1)² / ((2-1)(4-1))
  EXPECT_NEAR(Pressure::share_behind_front(s, 1.5), 0.25 / 3, 1e-15);   // a quarter of that
  EXPECT_NEAR(Pressure::share_behind_front(s, 3), 1 - 1.0 / 6, 1e-15);  // 1 - (4-3)² / ((4-2)(4-1))
  EXPECT_EQ(Pressure::share_behind_front({3, 3, 3}, 2.9), 0);
  EXPECT_EQ(Pressure::share_behind_front({3, 3, 3}, 3), 1);
  EXPECT_NEAR(Pressure::share_behind_front({0, 0, 2}, 1), 0.75, 1e-15);
  EXPECT_NEAR(Pressure::share_behind_front({0, 2, 2}, 1), 0.25, 1e-15);
}

/// (2), (3) with dual numbers.
TEST(CatchPressure, HasTheDerivativeOfItsForceAsTangent) {
  State<3> s = somewhere();
  s.cu = 0.7;
  const auto p = full(120);
  Points<Dual<9>, 3> x;
  for (int i = 0; i < 9; ++i)
    x[static_cast<std::size_t>(i / 3)][i % 3] =
        Dual<9>::variable(s.x[static_cast<std::size_t>(i / 3)][i % 3], i);
  const Vec3<Dual<9>> r = (-120.0 / 6) * cross(x[1] - x[0], x[2] - x[0]);
  Local<3> out;
  ASSERT_EQ(Pressure::Push::evaluate(p, {}, s, out), Status::ok);
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(out.force[static_cast<std::size_t>(i / 3)][i % 3], r[i % 3].value, 1e-12);
    for (std::size_t c = 0; c < 9; ++c)
      EXPECT_NEAR(out.tangent[i][c], 0.7 * r[i % 3].gradient[c], 1e-12) << i << ' ' << c;
  }
}

/// An octahedron, faces counter-clockwise seen from outside, pressed out of shape.
struct Closed {
  std::vector<Vec3<double>> x{{1, 0, 0},  {-1.2, 0.1, 0}, {0, 0.9, 0.2},
                              {0, -1, 0}, {0.1, 0, 1.1},  {0, 0, -1}};
  std::vector<std::array<std::size_t, 3>> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
};

// Over a closed surface the forces are those of -p × volume, and the tangents add up to a symmetric matrix.
TEST(CatchPressure, HasTheVolumeAsItsEnergyOverAClosedSurface) {
  const Closed c;
  std::array<Dual<18>, 18> flat;
  for (int i = 0; i < 18; ++i)
    flat[static_cast<std::size_t>(i)] = Dual<18>::variable(c.x[static_cast<std::size_t>(i / 3)][i % 3], i);
  const auto point = [&](std::size_t n) {
    return Vec3<Dual<18>>{flat[3 * n], flat[3 * n + 1], flat[3 * n + 2]};
  };
  Dual<18> energy;
  std::array<std::array<double, 18>, 18> K{};
  std::array<double, 18> r{};
  for (const auto& f : c.faces) {
    energy += (-50.0 / 6) * dot(point(f[0]), cross(point(f[1]), point(f[2])));
    State<3> s;
    for (std::size_t k = 0; k < 3; ++k) s.x[k] = c.x[f[k]];
    s.wants_tangent = true;
    Local<3> out;
    ASSERT_EQ(Pressure::Push::evaluate(full(50), {}, s, out), Status::ok);
    for (std::size_t i = 0; i < 9; ++i) {
      r[3 * f[i / 3] + i % 3] += out.force[i / 3][static_cast<int>(i % 3)];
      for (std::size_t j = 0; j < 9; ++j) K[3 * f[i / 3] + i % 3][3 * f[j / 3] + j % 3] += out.tangent[i][j];
    }
  }
  EXPECT_LT(energy.value, 0);  // it pushes outwards
  std::size_t entry = 0;
  for (std::size_t i = 0; i < 18; ++i) {
    EXPECT_NEAR(r[i], energy.gradient[i], 1e-12);
    for (std::size_t j = 0; j <= i; ++j, ++entry) {
      EXPECT_NEAR(K[i][j], energy.hessian[entry], 1e-12);
      EXPECT_NEAR(K[j][i], energy.hessian[entry], 1e-12);
    }
  }
}

}  // namespace
