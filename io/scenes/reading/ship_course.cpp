// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/ship_course.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::scenes {

namespace {

/// Largest turn of a ship between two points of its course. With this turn, the cubic between the points
/// deviates from an arc by 2e-8 of the radius.
constexpr double kArc = 0.05;  // [rad]

gears::ShipMoment between(const gears::ShipMoment& a, const gears::ShipMoment& b, double s) {
  return {a.t + s * (b.t - a.t), a.speed + s * (b.speed - a.speed), a.heading + s * (b.heading - a.heading)};
}

Course::Point velocity(const gears::Ship& ship, const gears::ShipMoment& m) {
  return {ship.speed - m.speed * std::cos(m.heading), m.speed * std::sin(m.heading), 0};
}

double rate_of_turn(const gears::ShipMoment& a, const gears::ShipMoment& b) {
  return (b.heading - a.heading) / (b.t - a.t);
}

/// The rate of turn at a moment where it jumps: the smaller of the rates before and after, or zero if their
/// signs differ. The velocity of a block also jumps at this moment, but a course has only one velocity at a
/// time. The resulting error is on the side of the faster turn, where the points of the course are close
/// together.
double at_corner(double before, double after) {
  if (before * after <= 0) return 0;
  return std::abs(before) < std::abs(after) ? before : after;
}

/// The moments of a ship's path, with further moments in between, so that the course follows (1) in
/// ship_course.hpp; `turns` is dψ/dt, the rate of turn [rad/s], at each of them.
struct Row {
  std::vector<gears::ShipMoment> moments;
  std::vector<double> turns;
};
Row divide(const std::vector<gears::ShipMoment>& path) {
  Row row{{path.front()}, {0}};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double turn = rate_of_turn(path[i - 1], path[i]);
    const int parts =
        std::max(1, static_cast<int>(std::ceil(std::abs(path[i].heading - path[i - 1].heading) / kArc)));
    if (i > 1) row.turns.back() = at_corner(row.turns.back(), turn);
    for (int k = 1; k <= parts; ++k) {
      row.moments.push_back(between(path[i - 1], path[i], double(k) / parts));
      row.turns.push_back(turn);
    }
  }
  row.turns.back() = 0;
  return row;
}

}  // namespace

Course course_of_block(const gears::Ship& ship, double from_the_middle) {
  const bool are_two = !ship.path_port.empty();
  const double across = are_two ? 0 : from_the_middle;
  const Row row = divide(are_two && from_the_middle < 0 ? ship.path_port : ship.path);
  Course course;
  Course::Point way{};
  for (std::size_t i = 0; i < row.moments.size(); ++i) {
    const gears::ShipMoment& m = row.moments[i];
    if (i > 0) {  // Simpson's rule
      const gears::ShipMoment& before = row.moments[i - 1];
      const auto v0 = velocity(ship, before), v1 = velocity(ship, between(before, m, 0.5)),
                 v2 = velocity(ship, m);
      for (std::size_t k = 0; k < 3; ++k) way[k] += (m.t - before.t) / 6 * (v0[k] + 4 * v1[k] + v2[k]);
    }
    const double s = std::sin(m.heading), c = std::cos(m.heading), turn = across * row.turns[i];
    Course::Knot knot{m.t, way, velocity(ship, m)};  // (1)
    knot.d[0] += across * s;
    knot.d[1] += across * (c - 1);
    knot.v[0] += turn * c;
    knot.v[1] -= turn * s;
    course.knots.push_back(knot);
  }
  return course;
}

}  // namespace netloft::scenes
