// SPDX-License-Identifier: BSD-3-Clause
//
// catch/pressure compared with values by hand and the gradient of the enclosed volume, and its tangent with
// dual numbers and differences.
#include "plugins/catch/pressure.hpp"

#include "tests/unit/plugins/kernel_oracle.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace {

using namespace netloft;
using catches::Pressure;

constexpr Pressure::Whole kAlone{1, 4};

Pressure::Parameters pressing(double pressure) {
  Pressure::Parameters p;
  p.pressure = pressure;
  return p;
}

Pressure::Parameters filled(double pressure, double volume) {
  Pressure::Parameters p = pressing(pressure);
  p.volume = volume;
  return p;
}

/// A triangle, with the front at `front` meshes from the aft edge.
State<4> somewhere(double front = 1e6) {
  State<4> s;
  s.x = {{{0.3, -0.2, 1}, {1.4, 0.1, 1.2}, {0.5, 0.9, 0.4}, {front, 0, 0}}};
  s.water = kSeaWater;
  s.wants_tangent = true;
  return s;
}

double fraction(const std::array<double, 3>& to_aft, double meshes) {
  return Pressure::fraction_behind_front(to_aft, meshes).value();
}

TEST(CatchPressure, PushesATriangleTowardsTheSideThatSeesItCounterClockwise) {
  State<4> s;
  s.x = {{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {1, 0, 0}}};
  Local<4> out;
  ASSERT_EQ(Pressure::Push::evaluate(pressing(100), {}, kAlone, s, out), Status::ok);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(out.force[i].z, -100 * 3.0 / 3);  // residual: minus a third of 100 Pa on 3 m²
    EXPECT_EQ(out.force[i].x, 0);
    EXPECT_EQ(out.force[i].y, 0);
  }
  EXPECT_EQ(out.force[3].x, 0);  // the position of the front is given
}

TEST(CatchPressure, IsThatOfTheFlowTheCatchStops) {
  Pressure::Parameters p;
  p.speed = 1.5, p.drag_coefficient = 1.4;
  EXPECT_NEAR(Pressure::on(p, {{0, 0, 0}}, somewhere(1)), 1614.375, 1e-10);  // 1.4 × ½ × 1025 × 1.5²
}

TEST(CatchPressure, CountsThePartOfATriangleBehindTheFront) {
  const std::array<double, 3> s{2, 4, 1};  // corners in any order
  EXPECT_EQ(fraction(s, 1), 0);
  EXPECT_DOUBLE_EQ(fraction(s, 4), 1);
  EXPECT_NEAR(fraction(s, 2), 1.0 / 3, 1e-15);      // (2-1)² / ((2-1)(4-1))
  EXPECT_NEAR(fraction(s, 1.5), 0.25 / 3, 1e-15);   // a quarter of that
  EXPECT_NEAR(fraction(s, 3), 1 - 1.0 / 6, 1e-15);  // 1 - (4-3)² / ((4-2)(4-1))
  EXPECT_EQ(fraction({3, 3, 3}, 2.9), 0);
  EXPECT_DOUBLE_EQ(fraction({3, 3, 3}, 3), 1);
  EXPECT_NEAR(fraction({0, 0, 2}, 1), 0.75, 1e-15);
  EXPECT_NEAR(fraction({0, 2, 2}, 1), 0.25, 1e-15);
}

// The fractions (2-1)/(2-1) and (2-1)/(4-1) of two sides are behind the front. The triangle between these
// parts of the sides has its centroid at the mean of its corners.
TEST(CatchPressure, ActsInTheMiddleOfThePartBehindTheFront) {
  const std::array<double, 3> s{2, 4, 1};
  const State<4> state = somewhere(2);
  const auto& x = state.x;
  const Vec3<double> corner = x[2], first = x[0], second = x[2] + (1.0 / 3) * (x[1] - x[2]);
  const Vec3<double> middle = (1.0 / 3) * (corner + first + second);
  const auto at = Pressure::fraction_behind_front(s, 2).at;
  const Vec3<double> acts = at[0] * x[0] + at[1] * x[1] + at[2] * x[2];
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(acts[axis], middle[axis] / 3, 1e-15);
  // Ahead of the corner that is furthest from the aft edge, the part without pressure is a triangle.
  const auto rest = Pressure::fraction_behind_front(s, 3).at;  // (4-3)/(4-2) and (4-3)/(4-1) of two sides
  const Vec3<double> bare = (1.0 / 3) * (x[1] + 0.5 * (x[1] + x[0]) + x[1] + (1.0 / 3) * (x[2] - x[1]));
  const Vec3<double> all = (1.0 / 3) * (x[0] + x[1] + x[2]);
  const Vec3<double> pressed = rest[0] * x[0] + rest[1] * x[1] + rest[2] * x[2];
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(pressed[axis], all[axis] - bare[axis] / 6, 1e-15);
}

/// The tangent is compared with (2), (3) of pressure.hpp in dual numbers.
TEST(CatchPressure, HasTheDerivativeOfItsForceAsTangent) {
  State<4> s = somewhere();
  s.cu = 0.7;
  Points<Dual<9>, 3> x;
  for (int i = 0; i < 9; ++i)
    x[static_cast<std::size_t>(i / 3)][i % 3] =
        Dual<9>::variable(s.x[static_cast<std::size_t>(i / 3)][i % 3], i);
  const Vec3<Dual<9>> r = (-120.0 / 6) * cross(x[1] - x[0], x[2] - x[0]);
  Local<4> out;
  ASSERT_EQ(Pressure::Push::evaluate(pressing(120), {}, kAlone, s, out), Status::ok);
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(out.force[static_cast<std::size_t>(i / 3)][i % 3], r[i % 3].value, 1e-12);
    for (std::size_t c = 0; c < 9; ++c)
      EXPECT_NEAR(out.tangent[i][c], 0.7 * r[i % 3].gradient[c], 1e-12) << i << ' ' << c;
  }
}

/// Checks (4), (8) and (9) of pressure.hpp on both branches of (5), along every axis.
TEST(CatchPressure, HasTheDerivativeOfItsVolumeAndFrontAsTangent) {
  for (const double front : {1.5, 3.0})
    for (const auto& [across, o] : std::vector<std::pair<std::int64_t, double>>{{0, 1}, {1, -1}, {2, 1}}) {
      Pressure::Parameters p = filled(120, 2.5);
      p.across = across, p.middle = -0.3;
      const Pressure::Data d{{2, 4, 1}, o};
      const auto force = [&](int dof, double step) {
        State<4> s = somewhere(front);
        s.x[static_cast<std::size_t>(dof / 3)][dof % 3] += step;
        Local<4> out;
        EXPECT_EQ(Pressure::Push::evaluate(p, d, {3, 4}, s, out), Status::ok);
        return out.force;
      };
      Local<4> out;
      ASSERT_EQ(Pressure::Push::evaluate(p, d, {3, 4}, somewhere(front), out), Status::ok);
      for (int c = 0; c < 12; ++c) {
        const auto more = force(c, 1e-4), less = force(c, -1e-4);
        for (int r = 0; r < 12; ++r) {
          const auto node = static_cast<std::size_t>(r / 3);
          EXPECT_NEAR(out.tangent[r][c], (more[node][r % 3] - less[node][r % 3]) / 2e-4, 1e-6)
              << front << ' ' << across << ' ' << r << ' ' << c;
        }
      }
    }
}

TEST(CatchPressure, IsTheSameHoweverTheCornersTurn) {
  const Pressure::Parameters p = filled(120, 2.5);
  State<4> s = somewhere(3), other = s;
  std::swap(other.x[1], other.x[2]);
  Local<4> out, turned;
  ASSERT_EQ(Pressure::Push::evaluate(p, {{2, 4, 1}}, {3, 4}, s, out), Status::ok);
  ASSERT_EQ(Pressure::Push::evaluate(p, {{2, 1, 4}, -1}, {3, 4}, other, turned), Status::ok);
  const int at[] = {0, 2, 1, 3};
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      EXPECT_NEAR(out.tangent[i][j], turned.tangent[3 * at[i / 3] + i % 3][3 * at[j / 3] + j % 3], 1e-12)
          << i << ' ' << j;
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(norm(out.force[i] - turned.force[static_cast<std::size_t>(at[i])]), 0, 1e-12) << i;
}

TEST(CatchPressure, SharesTheVolumeThatIsWantedOutAmongItsTriangles) {
  Local<4> out;
  const Pressure::Data ahead{{4, 4, 4}};
  ASSERT_EQ(Pressure::Push::evaluate(filled(10, 8), ahead, {5, 4}, somewhere(1), out), Status::ok);
  EXPECT_NEAR(out.force[3].x, -10.0 / 2 * 8 / 5, 1e-14);  // p / ∛8 × 8 m³ / 5
}

/// The table rises from 20 % to 100 % of 8 m³: in the middle it gives 60 %.
TEST(CatchPressure, GrowsByItsTable) {
  const double table[] = {10, 0.2, 20, 1};
  auto p = filled(120, 8);
  p.growth = {table, 2, 2};
  State<4> s = somewhere(3);
  s.time = 15;
  Local<4> growing, whole;
  Pressure::Push::evaluate(p, {}, kAlone, s, growing);
  Pressure::Push::evaluate(filled(120, 8), {}, kAlone, s, whole);
  EXPECT_NEAR(growing.force[3].x - whole.force[3].x, 120 / std::cbrt(8.0) * 0.4 * 8 / kAlone.triangles,
              1e-10);
}

TEST(CatchPressure, StartsAtAQuarterOfItsNetting) {
  Pressure::Whole whole;
  Pressure::gather({}, {{40, 80, 40}}, whole);
  Pressure::gather({}, {{0, 0, 40}}, whole);
  EXPECT_EQ(whole.triangles, 2);
  EXPECT_EQ(Pressure::first_front(filled(10, 8), whole), 20);
  Pressure::Parameters p = pressing(10);
  p.meshes = 33;
  EXPECT_EQ(Pressure::first_front(p, whole), 33);
}

TEST(CatchPressure, HasNoForceWhereTheFrontHasLeftTheNetting) {
  Local<4> out;
  EXPECT_THROW(Pressure::Push::evaluate(filled(10, 8), {}, kAlone, somewhere(4.1), out), OutsideDomain);
  EXPECT_THROW(Pressure::Push::evaluate(filled(10, 8), {}, kAlone, somewhere(-0.1), out), OutsideDomain);
}

TEST(CatchPressure, RefusesACatchThatIsGivenTwiceOrNotAtAll) {
  Pressure::Parameters none = pressing(10), twice = filled(10, 8), weak = filled(0, 8), slippery = weak;
  twice.meshes = 5;
  slippery.speed = 2, slippery.drag_coefficient = 0;
  for (const auto& p : {none, twice, weak, slippery})
    EXPECT_THROW(Pressure::check(p, {}), std::invalid_argument);
  EXPECT_NO_THROW(Pressure::check(filled(10, 8), {}));
  slippery.drag_coefficient = 1.4;
  EXPECT_NO_THROW(Pressure::check(slippery, {}));
}

TEST(CatchPressure, RefusesMoreMeshesThanThereAre) {
  Pressure::Parameters p = pressing(10);
  Pressure::Whole whole;
  whole.length = 8;
  p.meshes = 8;
  EXPECT_NO_THROW(Pressure::check_whole(p, whole));
  p.meshes = 8.1;
  EXPECT_THROW(Pressure::check_whole(p, whole), std::invalid_argument);
}

/// A deformed octahedron, whose faces are counter-clockwise as seen from outside.
struct Closed {
  std::vector<Vec3<double>> x{{1, 0, 0},  {-1.2, 0.1, 0}, {0, 0.9, 0.2},
                              {0, -1, 0}, {0.1, 0, 1.1},  {0, 0, -1}};
  std::vector<std::array<std::size_t, 3>> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  State<4> face(std::size_t f) const {
    State<4> s = somewhere();
    for (std::size_t k = 0; k < 3; ++k) s.x[k] = x[faces[f][k]];
    return s;
  }
};

double volume(const Closed& c, const Pressure::Parameters& p) {
  double sum = 0;
  for (std::size_t f = 0; f < c.faces.size(); ++f) sum += Pressure::volume(p, {}, c.face(f));
  return sum;
}

TEST(CatchVolume, IsThatOfAClosedSurfaceAlongEveryAxis) {
  const Closed c;
  double six = 0;
  for (const auto& f : c.faces) six += dot(c.x[f[0]], cross(c.x[f[1]], c.x[f[2]]));
  for (const std::int64_t across : {0, 1, 2}) {
    Pressure::Parameters p;
    p.across = across, p.middle = 0.7;
    EXPECT_NEAR(volume(c, p), six / 6, 1e-14);
  }
}

/// A pitched and displaced pyramid of 3 m height. Its open base of 4 m² is at the front of the catch.
TEST(CatchVolume, NeedsNoNettingAtTheFrontOfWhatIsTheSameOnBothSides) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  Closed pyramid;
  pyramid.x = {{0, 1, 1}, {0, -1, 1}, {0, -1, -1}, {0, 1, -1}, {3, 0, 0}};
  for (auto& x : pyramid.x) x = {c * x.x - s * x.z - 7, x.y, s * x.x + c * x.z - 50};
  pyramid.faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  EXPECT_NEAR(volume(pyramid, {}), 4.0, 1e-13);
  // Half of the pyramid, cut at the plane in the middle of the cod-end.
  pyramid.x[1].y = pyramid.x[2].y = 0;
  EXPECT_NEAR(volume(pyramid, {}), 2.0, 1e-13);
}

// On a closed surface, the forces are the gradient of -p × volume, and the tangents add up to a symmetric
// matrix.
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
  for (std::size_t face = 0; face < c.faces.size(); ++face) {
    const auto& f = c.faces[face];
    energy += (-50.0 / 6) * dot(point(f[0]), cross(point(f[1]), point(f[2])));
    Local<4> out;
    ASSERT_EQ(Pressure::Push::evaluate(pressing(50), {}, kAlone, c.face(face), out), Status::ok);
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
