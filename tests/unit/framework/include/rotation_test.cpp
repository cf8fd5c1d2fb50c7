// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/attitude.hpp>
#include <netloft/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace netloft {
namespace {

using V = Vec3<double>;
constexpr double kTurn = 6.283185307179586;

/// Rotation vectors of all sizes: zero, tiny, up to two turns, and exactly where the series ends.
std::vector<V> rotations() {
  std::vector<V> all{{0, 0, 0}, {1e-9, -2e-9, 1e-9}, {0.6, 0, 0.8}, {0, -3, 0.5}};
  std::mt19937 random(7);
  const auto number = [&] { return 2 * static_cast<double>(random()) / 4294967295.0 - 1; };
  for (int k = 0; k < 40; ++k) {
    const V d{number(), number(), number()};
    all.push_back((2 * kTurn * std::abs(number()) / norm(d)) * d);
  }
  return all;
}

TEST(Rotation, KeepsLengthsAnglesAndItsOwnAxis) {
  const V a{1, 2, -0.5}, b{0.3, -1, 2};
  for (const V& psi : rotations()) {
    EXPECT_NEAR(dot(rotated(psi, a), rotated(psi, b)), dot(a, b), 1e-13);
    EXPECT_LT(norm(rotated(psi, psi) - psi), 1e-13 * (1 + norm(psi)));
    EXPECT_LT(norm(cross(rotated(psi, a), rotated(psi, b)) - rotated(psi, cross(a, b))), 1e-12);
  }
}

TEST(Rotation, ByAQuarterTurnIsAQuarterTurn) {
  const V x{1, 0, 0}, quarter{0, 0, kTurn / 4};
  EXPECT_LT(norm(rotated(quarter, x) - V{0, 1, 0}), 1e-15);
}

/// Checks dR/dt r = ω × R r along a path of rotation vectors, and its derivative for the rate of ω.
TEST(Rotation, SpinIsTheRateAtWhichThingsTurn) {
  const V rate{0.7, -0.4, 1.1}, second{-0.5, 0.9, 0.2}, r{1, 2, -0.5};
  constexpr double h = 1e-4;
  for (const V& psi : rotations()) {
    const auto at = [&](double t) { return psi + t * rate + (0.5 * t * t) * second; };
    const V omega = spin_of(psi, rate), alpha = spin_rate_of(psi, rate, second);
    const V slope = (1 / (2 * h)) * (rotated(at(h), r) - rotated(at(-h), r));
    EXPECT_LT(norm(slope - cross(omega, rotated(psi, r))), 3e-7) << norm(psi);
    const auto spin_at = [&](double t) { return spin_of(at(t), rate + t * second); };
    EXPECT_LT(norm((1 / (2 * h)) * (spin_at(h) - spin_at(-h)) - alpha), 3e-7) << norm(psi);
  }
}

TEST(Rotation, AMomentDoesTheSameWorkOnTheVectorAsOnTheSpin) {
  const V moment{3, -1, 2}, rate{0.7, -0.4, 1.1};
  for (const V& psi : rotations()) {
    EXPECT_NEAR(dot(moment_on_vector(psi, moment), rate), dot(moment, spin_of(psi, rate)), 1e-12);
    const double turns = norm(psi) / kTurn;
    if (turns > 0.5 && std::abs(turns - std::round(turns)) < 0.02)
      continue;  // T has no inverse at full turns
    EXPECT_LT(norm(spin_of(psi, rate_of_spin(psi, rate)) - rate), 1e-9) << norm(psi);
    EXPECT_LT(norm(moment_on_vector(psi, rate_of_spin(-psi, moment)) - moment), 1e-9) << norm(psi);
  }
}

TEST(Rotation, IsFoundFromItsAxes) {
  for (const V& psi : rotations()) {
    const V found = rotation_vector(turned_axes(psi));
    EXPECT_LE(norm(found), kTurn / 2 + 1e-12);
    const auto axes = turned_axes(psi), again = turned_axes(found);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(norm(axes[k] - again[k]), 1e-12);
    EXPECT_LT(std::min(norm(shortened(psi) - found), norm(shortened(psi) + found)), 1e-11);
  }
  EXPECT_NEAR(norm(rotation_vector({V{-1, 0, 0}, V{0, -1, 0}, V{0, 0, 1}})), kTurn / 2, 1e-15);
}

TEST(Attitude, IsReadBackAsItWasGiven) {
  for (const double side : {1.0, -1.0})
    for (const double heading : {-2.0, 0.0, 0.6, 3.0})
      for (const double heel : {-1.0, 0.3, 2.9})
        for (const double trim : {-1.4, 0.0, 0.2}) {
          const Attitude a = attitude_of(axes_of({heading, heel, trim}, side), side);
          EXPECT_NEAR(a.heading, heading, 1e-13);
          EXPECT_NEAR(a.heel, heel, 1e-13);
          EXPECT_NEAR(a.trim, trim, 1e-13);
        }
}

/// The nose is the forward end of the x axis; the gear is towed against x.
TEST(Attitude, IsPositiveOutwardAndUp) {
  const auto starboard = axes_of({0.5, 0, 0}, 1), port = axes_of({0.5, 0, 0}, -1);
  EXPECT_NEAR((-starboard[0]).y, std::sin(0.5), 1e-15);
  EXPECT_NEAR((-port[0]).y, -std::sin(0.5), 1e-15);
  EXPECT_NEAR(axes_of({0, 0.5, 0}, 1)[2].y, std::sin(0.5), 1e-15);
  EXPECT_NEAR(axes_of({0, 0.5, 0}, -1)[2].y, -std::sin(0.5), 1e-15);
  EXPECT_NEAR((-axes_of({0, 0, 0.5}, 1)[0]).z, std::sin(0.5), 1e-15);
}

}  // namespace
}  // namespace netloft
