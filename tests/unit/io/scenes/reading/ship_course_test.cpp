// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/ship_course.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace netloft::scenes {
namespace {

constexpr double kSpeed = 1.5, kQuarter = std::numbers::pi / 2, kTurning = 120;  // [m/s], [rad], [s]

gears::Ship turning_ship() {
  gears::Ship ship;
  ship.speed = kSpeed;
  ship.path = {{0, kSpeed, 0}, {20, kSpeed, 0}, {20 + kTurning, kSpeed, kQuarter}};
  return ship;
}

TEST(CourseOfBlock, StaysWhileTheShipGoesOn) {
  const Course course = course_of_block(turning_ship(), 4);
  for (const double t : {0.0, 10.0, 19.0})
    EXPECT_NEAR(std::hypot(course.at(t).d[0], course.at(t).d[1]), 0, 1e-12);
}

/// While the ship turns, its path is a circle of radius R = V/ω. The course is measured from a point that
/// goes straight on.
TEST(CourseOfBlock, GoesRoundACircleAndOnStraight) {
  const double omega = kQuarter / kTurning, R = kSpeed / omega, across = -3;
  const Course course = course_of_block(turning_ship(), across);
  for (const double t : {30.0, 77.3, 131.0}) {
    const double psi = omega * (t - 20), s = std::sin(psi), c = std::cos(psi);
    EXPECT_NEAR(course.at(t).d[0], kSpeed * (t - 20) - R * s + across * s, 1e-5 * R) << t;
    EXPECT_NEAR(course.at(t).d[1], R * (1 - c) + across * (c - 1), 1e-5 * R) << t;
  }
  const Course::Moment at_once = course.at(20 + kTurning), later = course.at(30 + kTurning);
  EXPECT_NEAR(later.d[0] - at_once.d[0], 10 * kSpeed, 1e-9);  // the ship falls behind the point that goes on
                                                              // to -x
  EXPECT_NEAR(later.d[1] - at_once.d[1], 10 * kSpeed, 1e-9);  // and moves to starboard
}

TEST(CourseOfBlock, FallsBackByWhatTheShipIsSlower) {
  gears::Ship ship;
  ship.speed = 2;
  ship.path = {{0, 2, 0}, {10, 1, 0}};
  const Course course = course_of_block(ship, 3);
  EXPECT_NEAR(course.at(10).d[0], 5, 1e-12);
  EXPECT_NEAR(course.at(5).d[0], 1.25, 1e-12);
  EXPECT_NEAR(course.at(20).d[0], 15, 1e-12);
  EXPECT_EQ(course.at(20).d[1], 0);
}

/// Two ships turn away from each other by a right angle, each on a circle; afterwards they are 2 R farther
/// apart.
TEST(CourseOfBlock, IsThatOfItsOwnShipWhereTwoTow) {
  gears::Ship ships = turning_ship();
  ships.path_port = ships.path;
  for (auto& moment : ships.path_port) moment.heading *= -1;
  const double R = kSpeed * kTurning / kQuarter;
  const Course starboard = course_of_block(ships, 40), port = course_of_block(ships, -40);
  EXPECT_NEAR(starboard.at(20 + kTurning).d[1] - port.at(20 + kTurning).d[1], 2 * R, 1e-5 * R);
  EXPECT_NEAR(starboard.at(20 + kTurning).d[0], kSpeed * kTurning - R, 1e-5 * R);
  EXPECT_NEAR(port.at(20 + kTurning).d[0], kSpeed * kTurning - R, 1e-5 * R);
}

}  // namespace
}  // namespace netloft::scenes
