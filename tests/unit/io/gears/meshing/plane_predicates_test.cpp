// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/plane_predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

namespace netloft::gears {
namespace {

using Whole = boost::multiprecision::cpp_int;
using WholePoint = std::array<std::int64_t, 2>;

/// Signs of the determinants, computed in integers of any length, for coordinates that are multiples of one
/// power of two.
int whole_turn(const WholePoint& a, const WholePoint& b, const WholePoint& c) {
  const Whole left = (Whole(a[0]) - c[0]) * (Whole(b[1]) - c[1]),
              right = (Whole(a[1]) - c[1]) * (Whole(b[0]) - c[0]);
  return Whole(left - right).sign();
}

int whole_in_circle(const std::array<WholePoint, 4>& p) {
  Whole det = 0;
  std::array<Whole, 3> x, y;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = Whole(p[i][0]) - p[3][0];
    y[i] = Whole(p[i][1]) - p[3][1];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    det += (x[i] * x[i] + y[i] * y[i]) * (x[j] * y[k] - x[k] * y[j]);
  }
  return det.sign();
}

PlanePoint scaled(const WholePoint& p, int exponent) {
  return {std::ldexp(static_cast<double>(p[0]), exponent), std::ldexp(static_cast<double>(p[1]), exponent)};
}

/// How often each sign occurred, so that a test can check that all three did.
struct Signs {
  std::array<int, 3> times{};
  void count(int sign) { ++times[static_cast<std::size_t>(sign + 1)]; }
};

/// Compares both predicates with results in whole numbers, at scales from the least to the greatest that are
/// supported.
void expect_exact(const std::array<WholePoint, 4>& p, Signs& turns, Signs& circles) {
  const int turned = whole_turn(p[0], p[1], p[2]), circled = whole_in_circle(p);
  turns.count(turned);
  circles.count(circled);
  for (const int exponent : {-268, -40, 0, 196}) {
    std::array<PlanePoint, 4> q;
    for (std::size_t i = 0; i < 4; ++i) q[i] = scaled(p[i], exponent);
    ASSERT_EQ(turn(q[0], q[1], q[2]), turned) << exponent;
    ASSERT_EQ(turn(q[2], q[1], q[0]), -turned) << exponent;
    ASSERT_EQ(in_circle(q[0], q[1], q[2], q[3]), circled) << exponent;
    ASSERT_EQ(in_circle(q[0], q[2], q[1], q[3]), -circled) << exponent;
  }
}

class Draws {
 public:
  std::int64_t between(std::int64_t least, std::int64_t most) {
    return std::uniform_int_distribution<std::int64_t>(least, most)(engine_);
  }
  WholePoint point(std::int64_t farthest) {
    return {between(-farthest, farthest), between(-farthest, farthest)};
  }

 private:
  std::mt19937_64 engine_{1};
};

constexpr std::int64_t kFarthest = std::int64_t{1} << 53;  // whole numbers up to it are doubles

TEST(PlanePredicates, AreExactForPointsAnywhere) {
  Draws draws;
  Signs turns, circles;
  for (int i = 0; i < 5000; ++i)
    for (const std::int64_t farthest : {std::int64_t{3}, std::int64_t{1000}, kFarthest})
      expect_exact(
          {draws.point(farthest), draws.point(farthest), draws.point(farthest), draws.point(farthest)}, turns,
          circles);
  EXPECT_GT(*std::ranges::min_element(turns.times), 100);
  EXPECT_GT(*std::ranges::min_element(circles.times), 100);
}

TEST(PlanePredicates, AreExactForPointsNearOneLine) {
  Draws draws;
  Signs turns, circles;
  for (int i = 0; i < 20000; ++i) {
    const WholePoint from = draws.point(kFarthest / 2), step = draws.point(1000);
    std::array<WholePoint, 4> p;
    for (WholePoint& q : p) {
      const std::int64_t times = draws.between(-kFarthest / 4000, kFarthest / 4000);
      q = {from[0] + times * step[0], from[1] + times * step[1] + draws.between(-1, 1) * (i % 2)};
    }
    expect_exact(p, turns, circles);
  }
  EXPECT_GT(*std::ranges::min_element(turns.times), 1000);
}

// Points of whole numbers on one circle: 5² + 0² = 3² + 4², 65² = 16² + 63² = 33² + 56² = 25² + 60² = 39² +
// 52².
TEST(PlanePredicates, AreExactForPointsNearOneCircle) {
  constexpr std::array<WholePoint, 6> kOnCircle{{{65, 0}, {16, 63}, {33, 56}, {25, 60}, {39, 52}, {52, 39}}};
  Draws draws;
  Signs turns, circles;
  for (int i = 0; i < 20000; ++i) {
    const WholePoint middle = draws.point(kFarthest / 2);
    const std::int64_t scale = draws.between(1, kFarthest / 200);
    std::array<WholePoint, 4> p;
    for (WholePoint& q : p) {
      const WholePoint& on = kOnCircle[static_cast<std::size_t>(draws.between(0, 5))];
      const std::int64_t right = 2 * draws.between(0, 1) - 1, up = 2 * draws.between(0, 1) - 1;
      q = {middle[0] + scale * right * on[0],
           middle[1] + scale * up * on[1] + draws.between(-1, 1) * (i % 2)};
    }
    expect_exact(p, turns, circles);
  }
  EXPECT_GT(*std::ranges::min_element(circles.times), 1000);
}

// Points near the origin and far from it in one determinant give the longest sums.
TEST(PlanePredicates, AreExactForPointsOfVeryDifferentSize) {
  Draws draws;
  Signs turns, circles;
  for (int i = 0; i < 20000; ++i) {
    std::array<WholePoint, 4> p;
    for (WholePoint& q : p) {
      const auto any = [&] { return draws.between(-kFarthest, kFarthest) >> draws.between(0, 52); };
      q = {any(), any()};
    }
    expect_exact(p, turns, circles);
  }
}

TEST(LiftedCircle, DecidesForPointsOnOneCircleWhateverTheirOrder) {
  const std::array<PlanePoint, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const PlanePoint &a = square[i], &b = square[(i + 1) % 4], &c = square[(i + 2) % 4],
                     &d = square[(i + 3) % 4];
    // the paraboloid is highest at (1, 1), so that the diagonal runs from (0, 1) to (1, 0).
    const int side = d[0] != d[1] ? 1 : -1;
    EXPECT_EQ(in_lifted_circle(a, b, c, d), side);
    EXPECT_EQ(in_lifted_circle(b, c, a, d), side);
    EXPECT_EQ(in_lifted_circle(c, a, b, d), side);
  }
}

}  // namespace
}  // namespace netloft::gears
