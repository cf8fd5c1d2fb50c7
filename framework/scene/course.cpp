// SPDX-License-Identifier: BSD-3-Clause
#include "framework/scene/course.hpp"

#include <algorithm>

namespace netloft {

namespace {

Course::Moment beyond(const Course::Knot& end, double t) {
  Course::Moment m{end.d, end.v, {}};
  for (std::size_t i = 0; i < 3; ++i) m.d[i] += (t - end.t) * end.v[i];
  return m;
}

/// Displacement, speed and acceleration between two knots, by (1) of course.hpp and its derivatives.
Course::Moment between(const Course::Knot& p, const Course::Knot& q, double t) {
  const double H = q.t - p.t, s = (t - p.t) / H;
  Course::Moment m;
  for (std::size_t i = 0; i < 3; ++i) {
    const double rise = q.d[i] - p.d[i], v0 = H * p.v[i], v1 = H * q.v[i];
    const double c2 = 3 * rise - 2 * v0 - v1, c3 = v0 + v1 - 2 * rise;
    m.d[i] = p.d[i] + s * (v0 + s * (c2 + s * c3));
    m.v[i] = (v0 + s * (2 * c2 + 3 * s * c3)) / H;
    m.a[i] = (2 * c2 + 6 * s * c3) / (H * H);
  }
  return m;
}

}  // namespace

Course::Moment Course::at(double t) const {
  if (knots.empty()) return {};
  if (t < knots.front().t) return beyond(knots.front(), t);
  const auto next =
      std::upper_bound(knots.begin(), knots.end(), t, [](double time, const Knot& k) { return time < k.t; });
  return next == knots.end() ? beyond(knots.back(), t) : between(next[-1], *next, t);
}

}  // namespace netloft
