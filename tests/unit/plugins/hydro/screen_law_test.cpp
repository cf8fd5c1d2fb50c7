// SPDX-License-Identifier: BSD-3-Clause
//
// Laws of netting as a screen compared with their formulas in dual numbers and with the published
// polynomials.
#include "plugins/hydro/screen.hpp"

#include "tests/unit/plugins/hydro/law_oracle.hpp"

namespace {

using namespace netloft;
using hydro::Aarsnes;
using hydro::Knotted;
using hydro::KnottedParameters;
using hydro::KristiansenFaltinsen;
using hydro::Loland;
using hydro::ScreenParameters;

const ScreenParameters kOpen{1, 0}, kWake{0.9, 1};
constexpr double kTwine = 0.002;  // [m]

template <class L>
class ScreenLaw : public testing::Test {};
using Laws = testing::Types<Loland, Aarsnes, KristiansenFaltinsen>;

TYPED_TEST_SUITE(ScreenLaw, Laws);

TYPED_TEST(ScreenLaw, LanesMatchTheDualNumbersOfTheFormula) {
  for (const auto& p : {kOpen, kWake})
    for (const unsigned seed : {1u, 2u}) {
      TestFlow t = sample_flows(seed);
      expect_lanes_match_oracle<TypeParam>(p, t);
    }
}

template <class L>
class ScreenAtOneReynoldsNumber : public testing::Test {};
using Constant = testing::Types<Loland, Aarsnes>;
TYPED_TEST_SUITE(ScreenAtOneReynoldsNumber, Constant);

TYPED_TEST(ScreenAtOneReynoldsNumber, LanesMatchTheDualNumbersOfTheScaledFormula) {
  for (const double measured_at : {300.0, 4000.0}) {
    TestFlow t = sample_flows(3);
    expect_lanes_match_oracle<TypeParam>(ScreenParameters{0.9, 1, measured_at}, t);
  }
}

/// The cylinder has C_n = 1.1 + 4/√Re between Re = 30 and 10⁵.
TYPED_TEST(ScreenAtOneReynoldsNumber, FollowsTheDragOfACylinder) {
  const Vec3<double> normal{0.8, 0, 0.6};
  const double nu = 1.19e-6, Re = 1 * kTwine / nu;
  const auto plain = force_of<TypeParam>({1, 0, 0}, {1, 0, 0}, normal, kTwine, 0.2);
  const auto there = force_of<TypeParam>({1, 0, Re}, {1, 0, 0}, normal, kTwine, 0.2);
  const auto other = force_of<TypeParam>({1, 0, 400}, {1, 0, 0}, normal, kTwine, 0.2);
  EXPECT_NEAR(norm(there - plain), 0, 1e-12 * norm(plain));
  const double factor = (1.1 + 4 / std::sqrt(Re)) / (1.1 + 4 / std::sqrt(400));
  EXPECT_NEAR(norm(other - factor * plain), 0, 1e-12 * norm(plain));
}

constexpr auto kTakagi = static_cast<std::int64_t>(hydro::Cylinder::takagi);

/// Takagi's cylinder has C_n proportional to Re^−0.3 between Re = 14 and 160.
TYPED_TEST(ScreenAtOneReynoldsNumber, FollowsTakagisCylinderIfAskedTo) {
  const Vec3<double> normal{0.8, 0, 0.6};
  const double fast = 120 * kViscosity / kTwine, slow = 30 * kViscosity / kTwine;
  const ScreenParameters p{1, 0, 50, kTakagi};
  const double at_fast = norm(force_of<TypeParam>(p, {fast, 0, 0}, normal, kTwine, 0.2)),
               at_slow = norm(force_of<TypeParam>(p, {slow, 0, 0}, normal, kTwine, 0.2));
  EXPECT_NEAR(std::log(at_fast / at_slow) / std::log(4), 1.7, 1e-9);
}

/// Returns the coefficients of drag and lift that follow from the force, at an angle of the flow to the
/// normal.
template <class L>
std::pair<double, double> coefficients(double degrees, double S, double V = 1,
                                       const ScreenParameters& p = kOpen) {
  const double theta = degrees * std::numbers::pi / 180;
  const auto f = force_of<L>(p, {V, 0, 0}, {std::cos(theta), 0, std::sin(theta)}, kTwine, S);
  const double q = 0.5 * kDensity * V * V;
  return {f.x / q, f.z / q};
}

TYPED_TEST(ScreenLaw, DoesNotCareWhichSideIsOut) {
  const auto one = force_of<TypeParam>(kOpen, {1, 0.5, 0}, {0.8, 0, 0.6}, kTwine, 0.2);
  const auto other = force_of<TypeParam>(kOpen, {1, 0.5, 0}, {-0.8, 0, -0.6}, kTwine, 0.2);
  EXPECT_EQ(norm(one - other), 0);
}

TYPED_TEST(ScreenLaw, HasNoLiftStraightThroughAndAlong) {
  for (const double angle : {0.0, 90.0}) {
    const auto [drag, lift] = coefficients<TypeParam>(angle, 0.2);
    EXPECT_NEAR(lift, 0, 1e-15) << angle;
    EXPECT_GE(drag, 0) << angle;
  }
  EXPECT_GT(coefficients<TypeParam>(45, 0.2).second, 0.05);  // away from the flow, along the normal
}

TYPED_TEST(ScreenLaw, HasNoKinkAtGrazingAndNormalIncidence) {
  for (const double angle : {0.0, 87.0, 87.134, 90.0}) {
    const double h = 1e-4;
    const auto left = coefficients<TypeParam>(angle - h, 0.2), at = coefficients<TypeParam>(angle, 0.2),
               right = coefficients<TypeParam>(angle + h, 0.2);
    EXPECT_NEAR((right.first - at.first) / h, (at.first - left.first) / h, 2e-5) << angle;
    EXPECT_NEAR((right.second - at.second) / h, (at.second - left.second) / h, 2e-5) << angle;
  }
}

TYPED_TEST(ScreenLaw, IsZeroWithItsDerivativesInStillWater) {
  TestFlow t(1);
  t.set(0, {0, 0, 0}, {0, 0, 1}, kTwine, 0.2);
  TypeParam::lanes(kWake, t.f);
  EXPECT_EQ(norm(t.force(0)), 0);
  for (const auto& row : t.lanes.d_flow) EXPECT_EQ(row[0], 0);
  for (const auto& row : t.lanes.d_direction) EXPECT_EQ(row[0], 0);
  for (const auto& row : t.lanes.d_solidity) EXPECT_EQ(row[0], 0);
}

TYPED_TEST(ScreenLaw, SlowsTheWaterAsLolandsWakeSays) {
  const double S = 0.2, C_D = 0.33 * S + 6.54 * S * S - 4.88 * S * S * S;
  const double r = 0.9 * (1 - 0.46 * C_D);
  const double open = coefficients<TypeParam>(30, S, r).first,
               behind = coefficients<TypeParam>(30, S, 1, kWake).first;
  EXPECT_NEAR(behind / (open * r * r), 1, 1e-12);
}

TEST(Loland, HoldsTheForceOfNettingDenserThanAnyMeasured) {
  EXPECT_EQ(coefficients<Loland>(30, 0.38), coefficients<Loland>(30, 0.99));
  EXPECT_GT(coefficients<Loland>(30, 0.38), coefficients<Loland>(30, 0.34));
}

// C_D at S = 0.13 is 0.04 + (0.14270464 - 0.04) cos θ.
TEST(Loland, IsProportionalToTheTwinesOfNettingThinnerThanAnyMeasured) {
  for (const double S : {0.001, 0.05, 0.1}) {
    EXPECT_NEAR(coefficients<Loland>(0, S).first, 0.14270464 / 0.13 * S, 1e-12) << S;
    EXPECT_NEAR(coefficients<Loland>(90, S).first, 0.04 / 0.13 * S, 1e-12) << S;
    EXPECT_NEAR(coefficients<Loland>(45, S).second, 0.02850328 / 0.13 * S, 1e-12) << S;
  }
}

// Expected values: computed by hand from the published polynomials, S = 0.2.
TEST(Loland, HasThePublishedCoefficients) {
  EXPECT_NEAR(coefficients<Loland>(0, 0.2).first, 0.28856, 1e-12);
  EXPECT_NEAR(coefficients<Loland>(60, 0.2).first, 0.04 + 0.24856 * 0.5, 1e-12);
  EXPECT_NEAR(coefficients<Loland>(45, 0.2).second, 0.06792, 1e-12);
  EXPECT_NEAR(coefficients<Loland>(90, 0.2).first, 0.04, 1e-12);
}

TEST(Aarsnes, HasThePublishedCoefficients) {
  EXPECT_NEAR(coefficients<Aarsnes>(0, 0.2).first, 0.26, 1e-12);
  EXPECT_NEAR(coefficients<Aarsnes>(45, 0.2).second, 0.0532, 1e-12);
}

KnottedParameters knotted(double normal, double friction, double slope) {
  KnottedParameters p;
  p.shielding = 1, p.normal = normal, p.friction = friction, p.friction_slope = slope;
  return p;
}

TEST(Knotted, LanesMatchTheDualNumbersOfTheFormula) {
  for (const double measured_at : {0.0, 1000.0}) {
    KnottedParameters p = knotted(1.35, 0.4, 0.1);
    p.wake = 1, p.measured_at = measured_at, p.cylinder = kTakagi;
    TestFlow t = sample_flows(8);
    expect_lanes_match_oracle<Knotted>(p, t);
  }
}

/// Drag and lift coefficients on the area of the twines at an angle of attack, S = 0.2.
std::pair<double, double> knotted_coefficients(double attack, const KnottedParameters& p) {
  const double theta = (90 - attack) * std::numbers::pi / 180, q = 0.5 * kDensity * 0.2;
  const auto f = force_of<Knotted>(p, {1, 0, 0}, {std::cos(theta), 0, std::sin(theta)}, kTwine, 0.2);
  return {f.x / q, f.z / q};
}

TEST(Knotted, HasThePowersOfThePublishedAbstract) {
  const auto p = knotted(1.5, 0, 0);
  for (const double attack : {5.0, 20.0, 45.0, 89.0}) {
    const double s = std::sin(attack * std::numbers::pi / 180), c = std::cos(attack * std::numbers::pi / 180);
    const auto [drag, lift] = knotted_coefficients(attack, p);
    EXPECT_NEAR(drag, 1.5 * std::pow(s, 0.4), 1e-12) << attack;
    EXPECT_NEAR(lift, 1.5 * std::pow(s, 1.5) * c, 1e-12) << attack;
  }
}

TEST(Knotted, AddsFrictionAlongTheFlow) {
  const auto [without, no_lift] = knotted_coefficients(30, knotted(1.5, 0, 0));
  const auto [with, lift] = knotted_coefficients(30, knotted(1.5, 0.4, 0.2));
  EXPECT_NEAR(with - without, std::cos(std::numbers::pi / 6) * (0.4 + 0.2 * 0.5), 1e-12);
  EXPECT_NEAR(lift, no_lift, 1e-12);
  EXPECT_NEAR(knotted_coefficients(0, knotted(1.5, 0.4, 0.2)).first, 0.4, 1e-12);
}

TEST(Knotted, HasNoKinkAtGrazingAndNormalIncidence) {
  const auto p = knotted(1.5, 0.4, 0.1);
  for (const double attack : {0.0, 2.866, 87.134, 90.0}) {
    const double h = 1e-4;
    const auto left = knotted_coefficients(attack - h, p), at = knotted_coefficients(attack, p),
               right = knotted_coefficients(attack + h, p);
    EXPECT_NEAR((right.first - at.first) / h, (at.first - left.first) / h, 2e-4) << attack;
    EXPECT_NEAR((right.second - at.second) / h, (at.second - left.second) / h, 2e-4) << attack;
  }
}

// The polynomial gives 1.03439 at Re = 10³; S (2 − S)/(2 (1 − S)²) = 0.28125.
TEST(KristiansenFaltinsen, HasTheDragOfItsTwinesInFasterWater) {
  const double V = 800 * kViscosity / kTwine;  // Re = 10³ between the twines
  const double C_0 = coefficients<KristiansenFaltinsen>(0, 0.2, V).first;
  EXPECT_NEAR(C_0, 0.28125 * 1.03439, 1e-9);
  const double C_N = 0.5 * C_0, C_T = std::numbers::pi * C_N / (8 + C_N);
  EXPECT_NEAR(coefficients<KristiansenFaltinsen>(45, 0.2, V).second, (C_N - C_T) / std::numbers::sqrt2,
              1e-12);
}

}  // namespace
