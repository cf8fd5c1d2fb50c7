// SPDX-License-Identifier: BSD-3-Clause
//
// Laws of twines and ropes compared with their formulas in dual numbers and with values by hand, also where a
// formula is 0/0.
#include "plugins/hydro/morison.hpp"
#include "plugins/hydro/netting_twine.hpp"
#include "plugins/hydro/reynolds.hpp"

#include "tests/unit/plugins/hydro/law_oracle.hpp"

namespace {

using namespace netloft;
using hydro::Morison;
using hydro::MorisonReynolds;
using hydro::NettingTwine;

const Morison::Parameters kUsual{1.2, 0.08, 1};

double drag_coefficient(double Re) { return hydro::choo_casarella_phi(Re) / Re; }

TEST(Morison, LanesMatchTheDualNumbersOfTheFormula) {
  for (const double shielding : {1.0, 0.8, 0.0}) {
    TestFlow t = sample_flows(1);
    expect_lanes_match_oracle<Morison>({1.2, 0.08, shielding}, t);
  }
}

TEST(Morison, PushesAcrossAndAlongByHand) {
  // ½ 1025 0.02 1.2 1.5² across, ½ 1025 0.02 0.08 0.5² along
  const auto f = force_of<Morison>(kUsual, {1.5, 0, -0.5}, {0, 0, 1}, 0.02);
  EXPECT_DOUBLE_EQ(f.x, 27.675);
  EXPECT_DOUBLE_EQ(f.y, 0);
  EXPECT_DOUBLE_EQ(f.z, -0.205);
}

TEST(Morison, IsZeroWithAllItsDerivativesInStillWater) {
  TestFlow t(1);
  t.set(0, {0, 0, 0}, {0, 0, 1}, 0.02, 0);
  Morison::lanes(kUsual, t.f);
  for (const auto& row : t.lanes.d_flow) EXPECT_EQ(row[0], 0);
  for (const auto& row : t.lanes.d_direction) EXPECT_EQ(row[0], 0);
  EXPECT_EQ(norm(t.force(0)), 0);
}

TEST(Morison, TurnsSmoothlyThroughTheFlowAlongTheTwine) {
  TestFlow t(1);
  t.set(0, {2, 0, 0}, {1, 0, 0}, 0.02, 0);
  Morison::lanes(kUsual, t.f);
  EXPECT_DOUBLE_EQ(t.lanes.d_flow[0][0], 1025 * 0.02 * 0.08 * 2);  // 2 κ |τ|
  EXPECT_EQ(t.lanes.d_flow[4][0], 0);
  EXPECT_EQ(t.lanes.d_flow[8][0], 0);
}

TEST(Morison, FallsWithTheSquareOfShielding) {
  const auto open = force_of<Morison>(kUsual, {1, 2, 3}, {0, 1, 1}, 0.02);
  const auto behind = force_of<Morison>({1.2, 0.08, 0.5}, {1, 2, 3}, {0, 1, 1}, 0.02);
  EXPECT_NEAR(norm(behind - 0.25 * open), 0, 1e-12 * norm(open));
}

TEST(MorisonReynolds, LanesMatchTheDualNumbersOfTheFormula) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    TestFlow t = sample_flows(seed);
    expect_lanes_match_oracle<MorisonReynolds>({0.08, 0.9, {}}, t);
  }
}

// Expected values: computed separately from the published formulas of Choo and Casarella 1971.
TEST(MorisonReynolds, HasThePublishedCoefficientsAwayFromTheJoints) {
  EXPECT_NEAR(drag_coefficient(0.1), 55.641992, 1e-6);
  EXPECT_NEAR(drag_coefficient(0.5), 16.415579, 1e-6);
  EXPECT_DOUBLE_EQ(drag_coefficient(10), 1.45 + 8.55 * std::pow(10, -0.9));
  EXPECT_DOUBLE_EQ(drag_coefficient(100), 1.5);
  EXPECT_DOUBLE_EQ(drag_coefficient(1e4), 1.14);
}

TEST(MorisonReynolds, StaysWithinOnePercentOfThePublishedPiecesAtTheJoints) {
  EXPECT_NEAR(drag_coefficient(1), (9.8283 + 10) / 2, 0.001);  // 9.8283 from below, 10 from above
  EXPECT_NEAR(drag_coefficient(30), (1.8505 + 1.8303) / 2, 0.001);
}

double slope(double Re) { return hydro::choo_casarella_phi(Dual<1, 1>::variable(Re, 0)).gradient[0]; }

TEST(MorisonReynolds, HasNoStepAndNoKinkAtAnyJoint) {
  for (const double joint : {0.1, 0.8, 1.25, 24.0, 37.5}) {
    const double below = joint * (1 - 1e-9), above = joint * (1 + 1e-9);
    EXPECT_NEAR(hydro::choo_casarella_phi(above) / hydro::choo_casarella_phi(below), 1, 1e-8) << joint;
    EXPECT_NEAR(slope(above) / slope(below), 1, 1e-6) << joint;
  }
}

TEST(MorisonReynolds, IsLinearInTheVelocityAtRest) {
  TestFlow t(1);
  t.set(0, {0, 0, 0}, {0, 0, 1}, 0.001, 0);
  MorisonReynolds::lanes({0.08, 1, {}}, t.f);
  EXPECT_EQ(norm(t.force(0)), 0);
  EXPECT_NEAR(t.lanes.d_flow[0][0], 0.5 * kDensity * kViscosity * hydro::choo_casarella_phi(0.0), 1e-18);
  EXPECT_GT(t.lanes.d_flow[0][0], 0);
  EXPECT_EQ(t.lanes.d_flow[8][0], 0);
}

const double kTable[] = {10, 3, 100, 1.5, 1e3, 1.0, 1e4, 1.2};

TEST(MorisonReynolds, TakesATableInstead) {
  const MorisonReynolds::Parameters p{0, 1, {kTable, 4, 2}};
  const double D = 0.01;
  const auto coefficient = [&](double Re) {
    const double V = Re * kViscosity / D;
    return force_of<MorisonReynolds>(p, {V, 0, 0}, {0, 1, 0}, D).x / (0.5 * kDensity * D * V * V);
  };
  EXPECT_NEAR(coefficient(1), 3, 1e-12);
  EXPECT_NEAR(coefficient(100), 1.5, 1e-9);
  EXPECT_NEAR(coefficient(1e3), 1.0, 1e-9);
  EXPECT_NEAR(coefficient(1e6), 1.2, 1e-12);
  for (const double Re : {20.0, 50.0, 300.0, 700.0, 2e3, 8e3}) {  // no overshoot
    EXPECT_GE(coefficient(Re), 1.0 - 1e-12) << Re;
    EXPECT_LE(coefficient(Re), Re > 1e3 ? 1.2 : 3.0) << Re;
  }
  for (const unsigned seed : {4u, 5u}) {
    TestFlow t = sample_flows(seed);
    expect_lanes_match_oracle<MorisonReynolds>(p, t);
  }
}

const MorisonReynolds::Parameters kByTakagi{
    0.08, 0.9, {}, static_cast<std::int64_t>(hydro::Cylinder::takagi)};

TEST(MorisonReynolds, LanesMatchTheDualNumbersOfTakagisFormula) {
  for (const unsigned seed : {6u, 7u}) {
    TestFlow t = sample_flows(seed);
    expect_lanes_match_oracle<MorisonReynolds>(kByTakagi, t);
  }
}

TEST(Takagi, HasThePublishedCoefficientsAwayFromTheJoints) {
  EXPECT_NEAR(hydro::takagi_phi(100.0) / 100, 1.2589254, 1e-6);  // 10^(0.7 − 0.6)
  EXPECT_NEAR(hydro::takagi_phi(20.0) / 20, 2.0402858, 1e-6);
  EXPECT_DOUBLE_EQ(hydro::takagi_phi(1000.0) / 1000, 1.2);
  EXPECT_DOUBLE_EQ(hydro::takagi_phi(5.0), hydro::choo_casarella_phi(5.0));
}

TEST(Takagi, CrossesChooAndCasarellaWhereTheyAreJoined) {
  EXPECT_NEAR(std::pow(10, 0.7) * std::pow(11, -0.3) / drag_coefficient(11), 1, 0.002);
}

TEST(Takagi, HasNoStepAndNoKinkAtAnyJoint) {
  const auto slope_at = [](double Re) { return hydro::takagi_phi(Dual<1, 1>::variable(Re, 0)).gradient[0]; };
  for (const double joint : {8.8, 13.75, 160.0, 250.0}) {
    const double below = joint * (1 - 1e-9), above = joint * (1 + 1e-9);
    EXPECT_NEAR(hydro::takagi_phi(above) / hydro::takagi_phi(below), 1, 1e-8) << joint;
    EXPECT_NEAR(slope_at(above) / slope_at(below), 1, 1e-6) << joint;
  }
}

TEST(NettingTwine, LanesMatchTheDualNumbersOfTheFormula) {
  for (const std::int64_t cylinder : {0, 1})
    for (const unsigned seed : {9u, 10u}) {
      TestFlow t = sample_flows(seed);
      expect_lanes_match_oracle<NettingTwine>({0.9, 0.12, 2.5, cylinder}, t);
    }
}

/// Returns what a law writes for `count` flows of `all`, from `first` on, in a separate tile.
template <class L>
TestFlow alone(const typename L::Parameters& p, const TestFlow& all, std::size_t first, std::uint32_t count) {
  TestFlow t(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& from = all.lanes;
    t.set(i, {from.flow[0][first + i], from.flow[1][first + i], from.flow[2][first + i]}, {0, 0, 1},
          from.diameter[first + i], 0);
    for (int axis = 0; axis < 3; ++axis) t.lanes.direction[axis][i] = from.direction[axis][first + i];
  }
  L::lanes(p, t.f);
  return t;
}

template <class L>
void expect_same_bits_in_every_lane(const typename L::Parameters& p) {
  TestFlow all = sample_flows(11);
  L::lanes(p, all.f);
  for (const std::uint32_t count : {1u, 2u, 3u, 5u, 7u})
    for (std::size_t first = 0; first + count <= kLanes; ++first) {
      const TestFlow some = alone<L>(p, all, first, count);
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t r = 0; r < 3; ++r) ASSERT_EQ(some.lanes.force[r][i], all.lanes.force[r][first + i]);
        for (std::size_t r = 0; r < 9; ++r) {
          ASSERT_EQ(some.lanes.d_flow[r][i], all.lanes.d_flow[r][first + i]);
          ASSERT_EQ(some.lanes.d_direction[r][i], all.lanes.d_direction[r][first + i]);
        }
      }
    }
}

TEST(NettingTwine, HasTheSameBitsInEveryLane) {
  for (const std::int64_t cylinder : {0, 1})
    expect_same_bits_in_every_lane<NettingTwine>({0.9, 0.12, 2.5, cylinder});
}

TEST(MorisonReynolds, HasTheSameBitsInEveryLane) {
  for (const std::int64_t cylinder : {0, 1})
    expect_same_bits_in_every_lane<MorisonReynolds>({0.08, 0.9, {}, cylinder});
}

/// Force along x of a metre of twine at an angle to a flow along x, over ½ ρ D U² [1]; Re = U D/ν.
double pull(double degrees, double Re, const NettingTwine::Parameters& p) {
  const double a = degrees * std::numbers::pi / 180, D = 0.002, U = Re * kViscosity / D;
  return force_of<NettingTwine>(p, {U, 0, 0}, {std::cos(a), std::sin(a), 0}, D).x /
         (0.5 * kDensity * D * U * U);
}

TEST(NettingTwine, IsACylinderAcross) {
  EXPECT_NEAR(pull(90, 400, {1, 0, 2.5, 0}), 1.3, 1e-12);  // 1.1 + 4/√400
  EXPECT_NEAR(pull(90, 100, {1, 0, 2.5, 1}), 1.2589254, 1e-6);
}

// At 30° and Re = 200, the Reynolds number across is 100. The force along the flow is 1.5 sin³ 30° from drag
// across and 2π (0.55 √100 + 0.084 100^⅔)/200 cos² 30° from friction, within 1 % because ε is not zero.
TEST(NettingTwine, HasThePublishedFrictionAlong) {
  const double along = 2 * std::numbers::pi * (0.55 * 10 + 0.084 * std::pow(100, 2.0 / 3)) / 200 * 0.75;
  EXPECT_NEAR(pull(30, 200, {1, 0, 2.5, 0}) - 1.5 * 0.125, along, 0.01 * along);
}

TEST(NettingTwine, AddsKnotsThatHaveNoDirection) {
  for (const double angle : {0.0, 30.0, 90.0}) {
    const double knots = pull(angle, 200, {1, 0.1, 2.5, 0}) - pull(angle, 200, {1, 0, 2.5, 0});
    EXPECT_NEAR(knots, 0.1 * sphere_drag(500.0), 1e-12) << angle;
  }
}

TEST(NettingTwine, HasFrictionAndASlopeAlongTheTwine) {
  TestFlow t(1);
  t.set(0, {1, 0, 0}, {1, 0, 0}, 0.002, 0);
  NettingTwine::lanes({1, 0, 2.5, 0}, t.f);
  EXPECT_GT(t.force(0).x, 0);
  for (const auto& row : t.lanes.d_flow) EXPECT_TRUE(std::isfinite(row[0]));
  EXPECT_NEAR(t.lanes.d_flow[1][0], 0, 1e-12) << "even in the flow across";
}

TEST(NettingTwine, IsRegularInStillWater) {
  TestFlow t(1);
  t.set(0, {0, 0, 0}, {0, 0, 1}, 0.002, 0);
  NettingTwine::lanes({1, 0.1, 2.5, 0}, t.f);
  EXPECT_EQ(norm(t.force(0)), 0);
  EXPECT_GT(t.lanes.d_flow[0][0], 0) << "creeping flow";
  for (const auto& row : t.lanes.d_direction) EXPECT_EQ(row[0], 0);
}

TEST(MorisonReynolds, SaysThatItNeedsAViscosity) {
  TestFlow t(1);
  t.f.water_viscosity = 0;
  EXPECT_THROW(MorisonReynolds::lanes({0, 1, {}}, t.f), std::runtime_error);
}

}  // namespace
