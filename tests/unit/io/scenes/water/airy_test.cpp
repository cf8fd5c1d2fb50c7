// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/water/airy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace netloft::scenes {
namespace {

constexpr double kGravity = 9.81, kPi = std::numbers::pi;
constexpr double kAmplitude = 0.4, kPeriod = 8, kOmega = 2 * kPi / kPeriod;

AiryWaves waves_in(double depth, bool is_stretched = false, Current current = {}) {
  return AiryWaves({{{kAmplitude, kOmega, 0.3}}, 0, depth, 0, is_stretched}, kGravity, current);
}

class InDepths : public testing::TestWithParam<double> {};
// k d is 10, 1.4 and 0.4: deep water, intermediate depth, and nearly shallow water.
INSTANTIATE_TEST_SUITE_P(Airy, InDepths, testing::Values(160.0, 20.0, 2.5));

TEST_P(InDepths, DispersionHoldsToRounding) {
  for (const double period : {2.0, 5.0, 8.0, 14.0, 25.0}) {
    const double omega = 2 * kPi / period, k = wave_number(omega, kGravity, GetParam());
    EXPECT_NEAR(kGravity * k * std::tanh(k * GetParam()) / (omega * omega), 1, 2e-15) << period;
  }
}

/// The formulas of Dean and Dalrymple 1991, section 3.4, as they are printed there.
TEST_P(InDepths, KinematicsAreThoseOfTheBook) {
  const double d = GetParam(), k = wave_number(kOmega, kGravity, d);
  for (const double z : {-0.05 * d, -0.5 * d, -d})
    for (const double t : {0.0, 1.7, 6.1}) {
      const double theta = k * 3 - kOmega * t + 0.3, H = 2 * kAmplitude;
      const double C = std::cosh(k * (d + z)) / std::cosh(k * d),
                   S = std::sinh(k * (d + z)) / std::cosh(k * d);
      const WaterMotion water = waves_in(d).at({3, 5, z}, t);
      const double tiny = 1e-13;
      EXPECT_NEAR(water.velocity[0], H / 2 * kGravity * k / kOmega * C * std::cos(theta), tiny);
      EXPECT_NEAR(water.velocity[2], H / 2 * kGravity * k / kOmega * S * std::sin(theta), tiny);
      EXPECT_NEAR(water.acceleration[0], H / 2 * kGravity * k * C * std::sin(theta), tiny);
      EXPECT_NEAR(water.acceleration[2], -H / 2 * kGravity * k * S * std::cos(theta), tiny);
      EXPECT_NEAR(water.surface, kAmplitude * std::cos(theta), tiny);
      EXPECT_EQ(water.velocity[1], 0);
    }
}

TEST_P(InDepths, AccelerationAndSlopeAreThoseOfTheVelocity) {
  const AiryWaves waves = waves_in(GetParam());
  const double z = -0.3 * GetParam(), t = 2.2, h = 1e-4;
  const auto at = [&](double height, double time) { return waves.at({3, 0, height}, time).velocity; };
  const WaterMotion water = waves.at({3, 0, z}, t);
  for (const std::size_t i : {0u, 2u}) {
    EXPECT_NEAR((at(z, t + h)[i] - at(z, t - h)[i]) / (2 * h), water.acceleration[i], 1e-8);
    EXPECT_NEAR((at(z + h, t)[i] - at(z - h, t)[i]) / (2 * h), water.velocity_dz[i], 1e-8);
  }
}

TEST_P(InDepths, AreTheSameAfterAThousandPeriods) {
  const AiryWaves waves = waves_in(GetParam(), true);
  const WaterMotion early = waves.at({3, 0, -1}, 1.3), late = waves.at({3, 0, -1}, 1.3 + 1000 * kPeriod);
  for (const std::size_t i : {0u, 2u}) {
    EXPECT_NEAR(late.velocity[i], early.velocity[i], 1e-11);
    EXPECT_NEAR(late.acceleration[i], early.acceleration[i], 1e-11);
  }
}

/// With Wheeler's stretching (1970), water at the surface of a crest has the velocity of linear theory at z =
/// 0, and water at the bed the velocity of linear theory at the bed.
TEST(Airy, StretchingBringsTheSurfaceToZero) {
  const AiryWaves stretched = waves_in(20, true), linear = waves_in(20, false);
  const double crest = stretched.height({3, 0, 0}, 0.5);
  EXPECT_NEAR(stretched.at({3, 0, crest}, 0.5).velocity[0], linear.at({3, 0, 0}, 0.5).velocity[0], 1e-14);
  EXPECT_NEAR(stretched.at({3, 0, -20}, 0.5).velocity[0], linear.at({3, 0, -20}, 0.5).velocity[0], 1e-14);
  EXPECT_NEAR(stretched.at({3, 0, crest + 2}, 0.5).velocity[0], linear.at({3, 0, 0}, 0.5).velocity[0], 1e-14);
}

TEST(Airy, TravelIntoTheirDirection) {
  const AiryWaves waves({{{kAmplitude, kOmega, 0}}, kPi / 3, 20, 0, false}, kGravity, {});
  const double k = wave_number(kOmega, kGravity, 20), way = kOmega / k * 1.5;  // way of a crest in 1.5 s
  EXPECT_NEAR(waves.height({way * std::cos(kPi / 3), way * std::sin(kPi / 3), 0}, 1.5), kAmplitude, 1e-14);
  const auto v = waves.at({0, 0, -1}, 0).velocity;
  EXPECT_NEAR(v[1] / v[0], std::tan(kPi / 3), 1e-12);
}

/// A gear that is towed with speed U against the waves meets them with the frequency ω + k U (Dean and
/// Dalrymple 1991, section 3.4.6).
TEST(Airy, AreMetByATowedGearAtTheirPeriodOfEncounter) {
  Current aft;
  aft.tow = {-2, 0, 0};  // the gear moves to +x like the waves, so that U = -2 m/s
  const double k = wave_number(kOmega, kGravity, 20), period = 2 * kPi / (kOmega - 2 * k);
  const AiryWaves waves = waves_in(20, true, aft);
  EXPECT_NEAR(waves.height({3, 0, 0}, 0.4 + period), waves.height({3, 0, 0}, 0.4), 1e-13);
  EXPECT_GT(std::abs(waves.height({3, 0, 0}, 0.4 + kPeriod) - waves.height({3, 0, 0}, 0.4)), 0.01);
}

TEST(Airy, DriftCarriesThemByWhatItHasGone) {
  Current current;
  current.drifts = {{0, {0, 0, 0}}, {10, {1, 0, 0}}};
  EXPECT_NEAR(current.carried(10)[0], 5, 1e-14);
  EXPECT_NEAR(current.carried(20)[0], 15, 1e-14);
  EXPECT_NEAR(current.carried(4)[0], 0.8, 1e-14);
}

/// A current that is the same everywhere carries waves along, in whatever form it is given.
TEST(Airy, AreCarriedByEveryWayOfSayingACurrent) {
  const std::array<double, 3> v{0.7, 0.2, 0};
  const std::vector<Current> ways = {{.samples = {{0, v}}},
                                     {.samples = {{-50, v}, {0, v}}},
                                     {.samples = {{0, {1.4, 0.4, 0}}}, .factors = {{0, 0.5}, {10, 0.5}}},
                                     {.samples = {}, .drifts = {{-1, v}, {7, v}}},
                                     {.samples = {{0, {0.3, 0.2, 0}}}, .drifts = {{3, {0.4, 0, 0}}}},
                                     {.samples = {}, .tow = v}};
  for (const double t : {-3.0, 0.0, 4.0, 25.0})
    for (std::size_t i = 0; i < ways.size(); ++i)
      EXPECT_NEAR(waves_in(20, true, ways[i]).height({3, 1, 0}, t),
                  waves_in(20, true, ways.back()).height({3, 1, 0}, t), 1e-12)
          << i << " at " << t;
  const Current rising{.samples = {{0, v}}, .factors = {{0, 0}, {10, 1}}};
  EXPECT_NEAR(rising.carried(20)[0], 0.7 * 15, 1e-13);
  const Current sheared{.samples = {{-10, {0, 0, 0}}, {0, v}}};
  EXPECT_EQ(sheared.carried(20), (std::array<double, 3>{}));
}

TEST(Airy, GrowFromNothingOverTheRamp) {
  const AiryWaves waves({{{kAmplitude, kOmega, 0.3}}, 0, 20, 10, false}, kGravity, {});
  EXPECT_EQ(waves.at({3, 0, -1}, 0).velocity[0], 0);
  EXPECT_DOUBLE_EQ(waves.at({3, 0, -1}, 11).velocity[0], waves_in(20).at({3, 0, -1}, 11).velocity[0]);
  const double h = 1e-4;
  const double slope =
      (waves.at({3, 0, -1}, 4 + h).velocity[0] - waves.at({3, 0, -1}, 4 - h).velocity[0]) / (2 * h);
  EXPECT_NEAR(slope, waves.at({3, 0, -1}, 4).acceleration[0], 1e-8);
}

}  // namespace
}  // namespace netloft::scenes
