// SPDX-License-Identifier: BSD-3-Clause
//
// catch/front compared with values by hand and the volume of a box, and its tangent with differences.
#include "plugins/catch/front.hpp"

#include "tests/unit/plugins/kernel_oracle.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace {

using namespace netloft;
using catches::Front;

Front::Parameters pressed_front(double pressure, double volume = 0, double direction = 0) {
  Front::Parameters p;
  p.pressure = pressure, p.volume = volume, p.direction = direction;
  return p;
}

State<4> triangle(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c, double front) {
  State<4> s;
  s.x = {a, b, c, {front, 0, 0}};
  s.water = kSeaWater, s.wants_tangent = true;
  return s;
}

State<4> triangle_at(double front) {
  return triangle({0.3, -0.2, 1}, {1.4, 0.1, 1.2}, {0.5, 0.9, 0.4}, front);
}

/// The volume behind a front at ξ in a box that is open towards −x: x from 0 to 2, y and z from 0 to 1. The
/// volume is 2 − ξ.
double volume_of_box(double front, double direction = 0) {
  const std::array<Vec3<double>, 8> x{
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}}};
  constexpr std::array<std::array<std::size_t, 4>, 5> sides{
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {1, 2, 6, 5}}};
  double volume = 0;
  for (const auto& [a, b, c, d] : sides)
    for (const auto& [i, j, k] : {std::array{a, b, c}, std::array{a, c, d}}) {
      const double e = std::cos(direction), f = std::sin(direction);
      const auto turn = [&](const Vec3<double>& v) {
        return Vec3<double>{e * v.x - f * v.y, f * v.x + e * v.y, v.z};
      };
      volume += Front::volume(pressed_front(1, 1, direction), {},
                              triangle(turn(x[i]), turn(x[j]), turn(x[k]), front));
    }
  return volume;
}

TEST(CatchFront, AddsUpToTheVolumeBehindThePlane) {
  for (const double front : {-1.0, 0.0, 0.4, 1.7, 2.0, 3.0})
    EXPECT_NEAR(volume_of_box(front), front < 0 ? 3 : std::max(0.0, 2 - front), 1e-13) << front;
}

TEST(CatchFront, IsTheSameHoweverTheCornersTurn) {
  const Front::Parameters p = pressed_front(100, 0.7);
  State<4> s = triangle_at(0.5), other = s;
  std::swap(other.x[1], other.x[2]);
  Local<4> out, turned;
  ASSERT_EQ(Front::Push::evaluate(p, {}, {3}, s, out), Status::ok);
  ASSERT_EQ(Front::Push::evaluate(p, {-1}, {3}, other, turned), Status::ok);
  const std::size_t at[] = {0, 2, 1, 3};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(norm(out.force[i] - turned.force[at[i]]), 0, 1e-12) << i;
}

TEST(CatchFront, LooksAlongTheFlow) { EXPECT_NEAR(volume_of_box(0.4, 0.7), 1.6, 1e-13); }

TEST(CatchFront, PushesAThirdOnEachCornerOfWhatIsBehindIt) {
  Local<4> out;
  const State<4> s = triangle({0, 0, 0}, {2, 0, 0}, {0, 3, 0}, -1);
  ASSERT_EQ(Front::Push::evaluate(pressed_front(100), {}, {1}, s, out), Status::ok);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(-out.force[i].z, 100 * 3.0 / 3, 1e-12);  // area 3 m²
  EXPECT_EQ(out.force[3].x, 0);
}

TEST(CatchFront, LeavesWhatIsAheadOfIt) {
  Local<4> out;
  Front::Push::evaluate(pressed_front(100), {}, {1}, triangle_at(2), out);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(norm(out.force[i]), 0);
}

/// The sum of the fractions is the fraction of the area behind the plane, known here from similar triangles.
TEST(CatchFront, CutsTrianglesByTheAreaBehindIt) {
  const auto one = Front::behind(std::array<double, 3>{0.5, -0.5, -0.5});
  EXPECT_NEAR(one.w[0] + one.w[1] + one.w[2], 0.25, 1e-15);
  const auto two = Front::behind(std::array<double, 3>{0.5, 0.5, -0.5});
  EXPECT_NEAR(two.w[0] + two.w[1] + two.w[2], 0.75, 1e-15);
  EXPECT_NEAR(one.I, 0.25 * 0.5 / 3, 1e-15);  // a tetrahedron over a quarter of the area
}

TEST(CatchFront, HasTheDerivativeOfItsForceAsTangent) {
  for (const double front : {0.2, 0.4, 0.9, 1.3, 1.6}) {
    const auto p = pressed_front(120, 0.7, 0.3);
    const State<4> s = triangle_at(front);
    Local<4> at;
    ASSERT_EQ(Front::Push::evaluate(p, {}, {8}, s, at), Status::ok);
    for (int c = 0; c < 10; ++c) {
      const double h = 1e-5;
      Local<4> side[2];
      for (int k = 0; k < 2; ++k) {
        State<4> moved = s;
        moved.x[static_cast<std::size_t>(c / 3)][c % 3] += k ? h : -h;
        Front::Push::evaluate(p, {}, {8}, moved, side[k]);
      }
      for (int r = 0; r < 10; ++r) {
        const auto n = static_cast<std::size_t>(r / 3);
        EXPECT_NEAR(at.tangent[r][c], (side[1].force[n][r % 3] - side[0].force[n][r % 3]) / (2 * h), 1e-5)
            << front << " " << r << " " << c;
      }
    }
  }
}

/// The table rises from 20 % to 100 % of 0.7 m³: in the middle of the table the catch is 60 %, and before the
/// table begins 20 %.
TEST(CatchFront, GrowsByItsTable) {
  const double table[] = {10, 0.2, 20, 1};
  auto p = pressed_front(120, 0.7);
  p.growth = {table, 2, 2};
  const double k = 120 / std::cbrt(0.7);
  for (const auto& [time, share] : {std::pair{0.0, 0.2}, {15.0, 0.6}, {99.0, 1.0}}) {
    State<4> s = triangle_at(0.8);
    s.time = time;
    Local<4> out;
    Front::Push::evaluate(p, {}, {8}, s, out);
    EXPECT_NEAR(out.force[3].x, k * (share * 0.7 / 8 - Front::volume(p, {}, s)), 1e-12) << time;
  }
}

TEST(CatchFront, GrowsOnlyIfItIsAVolumeThatIsThereAlways) {
  const double growing[] = {0, 0.2, 20, 1}, vanishing[] = {0, 1, 20, 0};
  auto p = pressed_front(120);
  p.growth = {growing, 2, 2};
  EXPECT_THROW(Front::check(p, {}), std::invalid_argument);
  p.volume = 0.7;
  EXPECT_NO_THROW(Front::check(p, {}));
  p.growth = {vanishing, 2, 2};
  EXPECT_THROW(Front::check(p, {}), std::invalid_argument);
}

TEST(CatchFront, RefusesACatchWithoutPressure) {
  EXPECT_THROW(Front::check({}, {}), std::invalid_argument);
  EXPECT_NO_THROW(Front::check(pressed_front(1), {}));
}

}  // namespace
