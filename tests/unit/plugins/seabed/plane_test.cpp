// SPDX-License-Identifier: BSD-3-Clause
//
// seabed/plane: each branch of the contact force is compared with the energy differentiated by dual numbers,
// friction with values by hand, and the tangent of friction with differences.
#include "plugins/seabed/plane.hpp"

#include "tests/unit/plugins/kernel_oracle.hpp"

namespace {

using namespace netloft;
using seabed::Plane;

constexpr Water kWater{1025, 9.81};
constexpr double kSoftBed = 0.02;

Plane::Parameters sloping() {
  Plane::Parameters p;
  p.depth = 50, p.slope_x = 0.2, p.slope_y = -0.1, p.stiffness = 3e4, p.softness = kSoftBed;
  p.friction = 0.6, p.shear_stiffness = 2e4;
  return p;
}

const std::vector<Plane::Data> kTwoMetres(kLanes, Plane::Data{2, 7});

/// Places nodes at depths between `least` and `most` below a sloping bed, measured along z. The nodes are
/// near the origin, so that depths do not lose digits.
void place_nodes(TestTile<1>& tile, double least, double most) {
  std::mt19937_64 random(5);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const double x = uniform(random, -0.1, 0.1), y = uniform(random, -0.1, 0.1);
    tile.x[lane] = x, tile.x[kLanes + lane] = y;
    tile.x[2 * kLanes + lane] = 0.2 * x - 0.1 * y - uniform(random, least, most);
  }
}

void expect_contact_matches(double least, double most) {
  TestTile<1> tile(kWater);
  place_nodes(tile, least, most);
  Plane::Parameters p = sloping();
  p.depth = 0;
  expect_kernel_matches_oracle<Plane, Plane::Contact>(p, kTwoMetres, kWater, tile, false);
}

TEST(SeabedContact, MatchesItsOracleAboveTheBed) { expect_contact_matches(-1, -1e-3); }
TEST(SeabedContact, MatchesItsOracleWhereTheBedIsSoft) { expect_contact_matches(1e-3, 0.9 * kSoftBed); }
TEST(SeabedContact, MatchesItsOracleDeepInTheBed) { expect_contact_matches(2 * kSoftBed, 1); }

TEST(SeabedContact, HasNoJumpInEnergyForceOrStiffness) {
  for (const double joint : {0.0, kSoftBed}) {
    const auto before = Plane::press(joint - 1e-12, kSoftBed), after = Plane::press(joint + 1e-12, kSoftBed);
    EXPECT_NEAR(before.f, after.f, 1e-13);
    EXPECT_NEAR(before.f1, after.f1, 1e-11);
    EXPECT_NEAR(before.f2, after.f2, 1e-9);
  }
}

// The distance from a plane through (0, 0, -50) with the normal (-0.2, 0.1, 1).
TEST(SeabedContact, HasAGapAlongItsNormal) {
  State<1> s;
  for (const double height : {-0.3, 0.7}) {
    const double n = std::sqrt(1 + 0.04 + 0.01);
    s.x[0] = {3 - 0.2 / n * height, 5 + 0.1 / n * height, -50 + 0.2 * 3 - 0.1 * 5 + height / n};
    EXPECT_NEAR(Plane::gap(sloping(), s), height, 1e-13);
    EXPECT_EQ(Plane::normal_force(sloping(), {2, 0}, s) > 0, height < 0);
  }
}

TEST(SeabedContact, CarriesAWireWhereItsWeightSaysSo) {  // ε/2 + w/k below
  Plane::Parameters p = sloping();
  p.slope_x = p.slope_y = 0, p.stiffness = 1e4;
  State<1> s;
  s.x[0].z = -50 - (kSoftBed / 2 + 0.1);
  EXPECT_NEAR(Plane::normal_force(p, {2, 0}, s), 2 * 1e4 * 0.1, 1e-9);
  // a piece without length counts as one metre
  EXPECT_NEAR(Plane::normal_force(p, {0, 3}, s), 3 * 1e4 * 0.1, 1e-9);
}

TEST(SeabedContact, RefusesToCarryLessThanNothing) {
  EXPECT_THROW(Plane::check(sloping(), {-1, 0}), std::invalid_argument);
  EXPECT_THROW(Plane::check(sloping(), {1, -1}), std::invalid_argument);
}

/// A node 0.11 m deep in a level bed, N = 2000 N on 2 m of rope, with the memory of one lane.
struct OneNode {
  OneNode() {
    p.slope_x = p.slope_y = 0, p.stiffness = 1e4, p.friction = 0.5, p.shear_stiffness = 1e4;
    t.size = sizeof t, t.count = 1, t.cu = 1;
    t.x = x, t.force = force, t.inputs = inputs;
    x[2 * kLanes] = -50 - kSoftBed / 2 - 0.1;
    state[3 * kLanes] = 1;
  }
  void evaluate() {
    std::fill_n(force, 3 * kLanes, 0.0);
    std::fill_n(tangent, 9 * kLanes, 0.0);
    const auto family = make_family<Plane>(p, kTwoMetres);
    ASSERT_EQ(Plane::Friction::tile(family, t), Status::ok);
  }
  void accept() { std::copy_n(state_new, 4 * kLanes, state); }
  Plane::Parameters p = sloping();
  double x[3 * kLanes] = {}, force[3 * kLanes] = {}, tangent[9 * kLanes] = {};
  double state[4 * kLanes] = {}, state_new[4 * kLanes] = {};
  netloft_remembered memory{sizeof memory, 0, state, state_new};
  const void* inputs[detail::kInputPlaces] = {nullptr, nullptr, &memory};
  netloft_tile t{};
};

TEST(SeabedFriction, SticksToItsAnchorByASpring) {
  OneNode n;
  n.x[0] = 0.03, n.x[kLanes] = -0.02;  // 2e4 N/m: 600 and -400 N, less than 1000 N
  n.evaluate();
  EXPECT_NEAR(n.force[0], 600, 1e-9);
  EXPECT_NEAR(n.force[kLanes], -400, 1e-9);
  EXPECT_EQ(n.force[2 * kLanes], 0);
  n.accept();
  EXPECT_EQ(n.state[0], 0);
  EXPECT_EQ(n.state[kLanes], 0);
}

TEST(SeabedFriction, SlidesBeyondTheShareOfTheNormalForceAndDragsItsAnchorAlong) {
  OneNode n;
  n.x[0] = 0.3, n.x[kLanes] = 0.4;
  n.evaluate();
  EXPECT_NEAR(n.force[0], 600, 1e-9);  // 0.5 x 2000 N along (0.6, 0.8)
  EXPECT_NEAR(n.force[kLanes], 800, 1e-9);
  n.accept();
  EXPECT_NEAR(n.state[0], 0.3 - 0.05 * 0.6, 1e-12);  // the anchor is 1000 N / 2e4 N/m behind
  const double before = n.force[0];
  n.evaluate();
  EXPECT_NEAR(n.force[0], before, 1e-9) << "remembering changes no force";
}

TEST(SeabedFriction, SticksWhereItCameToRestWhateverIsRoundedOff) {
  for (int k = 1; k < 200; ++k) {
    OneNode n;
    n.t.tangent = n.tangent, n.t.want = NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT;
    n.x[0] = 100 + 0.37 * k, n.x[kLanes] = -3.1 * k;  // far enough to slide
    n.evaluate();
    n.accept();
    n.evaluate();
    const double stuck = n.tangent[0] * n.tangent[4 * kLanes] - n.tangent[kLanes] * n.tangent[3 * kLanes];
    EXPECT_NEAR(stuck, 2e4 * 2e4, 1) << "the spring resists along every direction, " << k;
  }
}

TEST(SeabedFriction, HoldsALoadForEverOnceItSticks) {
  OneNode n;
  n.x[0] = 0.03;
  for (int step = 0; step < 100; ++step) {
    n.evaluate();
    n.accept();
  }
  EXPECT_EQ(n.state[0], 0) << "what sticks does not creep";
}

/// The node of OneNode on a bed that moves with (1.2, −0.5) m/s.
struct OnPassingBed : OneNode {
  OnPassingBed() { inputs[detail::kGroundPlace] = &passing, t.v = v; }
  double ground[3] = {1.2, -0.5, 0};
  netloft_ground passing{sizeof passing, 0, ground, nullptr};
  double v[3 * kLanes] = {};
};

TEST(SeabedFriction, OfAPassingBedDragsTheNodeAlongWhereverItWasSketched) {
  OnPassingBed n;
  for (const double x : {0.0, 0.3}) {
    n.x[0] = x;
    n.evaluate();
    EXPECT_NEAR(n.force[0], -1000 * 12.0 / 13, 1e-9);  // 0.5 x 2000 N against the residual
    EXPECT_NEAR(n.force[kLanes], 1000 * 5.0 / 13, 1e-9);
    n.accept();
  }
}

TEST(SeabedFriction, OfAPassingBedIsThatOfTheVelocityOverIt) {
  OnPassingBed n;
  n.v[0] = 1.2, n.v[kLanes] = 0.5;  // the bed passes with (0, −1) m/s
  n.evaluate();
  EXPECT_NEAR(n.force[0], 0, 1e-9);
  EXPECT_NEAR(n.force[kLanes], 1000, 1e-9);
  n.v[kLanes] = -0.5;  // as the bed
  n.evaluate();
  EXPECT_EQ(n.force[0], 0);
  EXPECT_EQ(n.force[kLanes], 0);
}

TEST(SeabedFriction, HasNoJumpWhereANodeBeginsToSlide) {
  const auto before = Plane::slip(0.02 * (1 - 1e-9), 0.02), after = Plane::slip(0.02 * (1 + 1e-9), 0.02);
  EXPECT_NEAR(before.h, after.h, 1e-6);
  EXPECT_NEAR(before.h + 0.02 * 0.02 * before.slope, 0, 1e-6) << "d(h s)/ds";
  EXPECT_NEAR(after.h + 0.02 * 0.02 * after.slope, 0, 1e-6);
}

TEST(SeabedFriction, LetsGoAboveTheBedAndTakesTheAnchorAlong) {
  OneNode n;
  n.x[0] = 4, n.x[2 * kLanes] = -49;
  n.t.tangent = n.tangent, n.t.want = NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT;
  n.evaluate();
  EXPECT_EQ(n.force[0], 0);
  n.accept();
  EXPECT_EQ(n.state[0], 4);
  n.evaluate();
  EXPECT_EQ(n.tangent[0], 0) << "above its anchor, too, nothing holds it";
  EXPECT_EQ(n.state[2 * kLanes], -49);
}

TEST(SeabedFriction, IsNothingWithoutAPast) {
  OneNode n;
  n.state[3 * kLanes] = 0, n.x[0] = 3;
  n.evaluate();
  EXPECT_EQ(n.force[0], 0);
  EXPECT_EQ(n.state_new[0], 3);
  EXPECT_EQ(n.state_new[3 * kLanes], 1);
  n.inputs[detail::kMemoryPlace] = nullptr;
  n.evaluate();
  EXPECT_EQ(n.force[0], 0);
}

/// Compares the tangent with central differences on a sloping bed. The tangent is unsymmetric while the node
/// slides.
void expect_tangent_is_derivative(double way, double depth) {
  OneNode n;
  n.p = sloping();
  n.x[0] = way, n.x[kLanes] = -0.3 * way, n.x[2 * kLanes] = -50 + 0.2 * way + 0.03 * way - depth;
  n.state[2 * kLanes] = -50;
  n.t.tangent = n.tangent, n.t.want = NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT, n.t.cu = 0.7;
  n.evaluate();
  double K[9];
  for (std::size_t e = 0; e < 9; ++e) K[e] = n.tangent[e * kLanes];
  for (std::size_t c = 0; c < 3; ++c) {
    const double h = 1e-6, x = n.x[c * kLanes];
    double slope[3];
    for (const double sign : {1.0, -1.0}) {
      n.x[c * kLanes] = x + sign * h;
      n.evaluate();
      for (std::size_t r = 0; r < 3; ++r)
        slope[r] = (sign > 0 ? 0 : slope[r]) + sign * n.force[r * kLanes] / (2 * h);
    }
    n.x[c * kLanes] = x;
    for (std::size_t r = 0; r < 3; ++r) EXPECT_NEAR(K[3 * r + c], 0.7 * slope[r], 1e-2) << r << c;  // of 4e4
  }
}

TEST(SeabedFriction, HasTheDerivativeAsTangentWhileItSticks) { expect_tangent_is_derivative(0.01, 0.3); }
TEST(SeabedFriction, HasTheDerivativeAsTangentWhileItSlides) { expect_tangent_is_derivative(2, 0.3); }
TEST(SeabedFriction, HasTheDerivativeAsTangentInTheSoftBed) {
  expect_tangent_is_derivative(1, 0.5 * kSoftBed);
}
TEST(SeabedFriction, HasTheDerivativeAsTangentAboveTheBed) { expect_tangent_is_derivative(1, -0.1); }

/// Compares the tangents by position and by velocity with central differences on a sloping, moving bed.
void expect_tangent_of_passing_bed(double vx, double vy) {
  OnPassingBed n;
  n.p = sloping();
  n.x[2 * kLanes] = -50.3, n.v[0] = vx, n.v[kLanes] = vy;
  n.t.tangent = n.tangent, n.t.want = NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT;
  for (const bool of_velocity : {false, true}) {
    n.t.cu = of_velocity ? 0 : 0.7, n.t.cv = of_velocity ? 0.3 : 0;
    n.evaluate();
    std::vector<double> K(n.tangent, n.tangent + 9 * kLanes);
    for (std::size_t c = 0; c < 3; ++c) {
      double& q = (of_velocity ? n.v : n.x)[c * kLanes];
      const double h = 1e-6, middle = q;
      double slope[3] = {};
      for (const double sign : {1.0, -1.0}) {
        q = middle + sign * h;
        n.evaluate();
        for (std::size_t r = 0; r < 3; ++r) slope[r] += sign * n.force[r * kLanes] / (2 * h);
      }
      q = middle;
      for (std::size_t r = 0; r < 3; ++r)
        EXPECT_NEAR(K[(3 * r + c) * kLanes], (n.t.cu + n.t.cv) * slope[r], 1e-2) << r << c;  // of 4e4 and 4e5
    }
  }
}

TEST(SeabedFriction, HasTheDerivativeAsTangentOnAPassingBed) { expect_tangent_of_passing_bed(0.3, 0.1); }
TEST(SeabedFriction, HasTheDerivativeAsTangentWhileItCreeps) { expect_tangent_of_passing_bed(1.203, -0.498); }

}  // namespace
