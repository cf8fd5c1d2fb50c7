// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/plane_predicates.hpp"

#include "io/gears/meshing/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace netloft::gears {

namespace {

constexpr double kHalfUlp = 0x1p-53;  // the rounding error of one operation, relative to its result
// Shewchuk's bounds A of the error of the determinants, relative to the sums of the magnitudes of their
// terms.
constexpr double kTurnBound = (3 + 16 * kHalfUlp) * kHalfUlp, kCircleBound = (10 + 96 * kHalfUlp) * kHalfUlp;

int sign_of(double x) { return (x > 0) - (x < 0); }

int exact_turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (exact_difference(a[0], c[0]) * exact_difference(b[1], c[1]) -
          exact_difference(a[1], c[1]) * exact_difference(b[0], c[0]))
      .sign();
}

int exact_in_circle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  const auto ax = exact_difference(a[0], d[0]), ay = exact_difference(a[1], d[1]),
             bx = exact_difference(b[0], d[0]), by = exact_difference(b[1], d[1]),
             cx = exact_difference(c[0], d[0]), cy = exact_difference(c[1], d[1]);
  const auto of_a = (ax * ax + ay * ay) * (bx * cy - cx * by),
             of_b = (bx * bx + by * by) * (cx * ay - ax * cy),
             of_c = (cx * cx + cy * cy) * (ax * by - bx * ay);
  return (of_a + of_b + of_c).sign();
}

}  // namespace

int turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]),
               det = left - right;
  if (std::abs(det) > kTurnBound * (std::abs(left) + std::abs(right))) return sign_of(det);
  return exact_turn(a, b, c);
}

int in_circle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1], cx = c[0] - d[0],
               cy = c[1] - d[1];
  const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const double det = aa * (bx * cy - cx * by) + bb * (cx * ay - ax * cy) + cc * (ax * by - bx * ay);
  const double sum = aa * (std::abs(bx * cy) + std::abs(cx * by)) +
                     bb * (std::abs(cx * ay) + std::abs(ax * cy)) +
                     cc * (std::abs(ax * by) + std::abs(bx * ay));
  if (std::abs(det) > kCircleBound * sum) return sign_of(det);
  return exact_in_circle(a, b, c, d);
}

int in_lifted_circle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  if (const int side = in_circle(a, b, c, d); side != 0) return side;
  std::array<const PlanePoint*, 4> greatest_first{&a, &b, &c, &d};
  std::ranges::sort(greatest_first, [](const PlanePoint* p, const PlanePoint* q) { return *p > *q; });
  for (const PlanePoint* p : greatest_first) {
    if (p == &d) return -1;  // lifted off the plane through a, b, c
    // If a corner and d are on the same side of the line through the other two corners, lifting the corner
    // lifts the plane at d.
    const int side = p == &a ? turn(d, b, c) : p == &b ? turn(a, d, c) : turn(a, b, d);
    if (side != 0) return side;
  }
  return 0;
}

}  // namespace netloft::gears
