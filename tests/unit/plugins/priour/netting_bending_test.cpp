// SPDX-License-Identifier: BSD-3-Clause
//
// Bending between two triangles of netting compared with its energy differentiated by dual numbers, and with
// values by hand.
#include "plugins/priour/netting_bending.hpp"

#include "tests/unit/plugins/kernel_oracle.hpp"

#include <numbers>

namespace {

using namespace netloft;
using priour::Bending;

const Bending::Parameters kStiffTwine{2e-3, std::numbers::pi / 4};

/// Two triangles on both sides of the edge (0, 0)-(0, 4), along v; altitudes of 3 and 5 bars at 45°.
const Bending::Data kPair{{0, 0, 3, -5}, {0, 4, 1, 2}, {0.1, 0.1}};

/// The pair folded by `phi`, unstretched at 45°, somewhere in space.
State<4> folded(double phi) {
  State<4> s;
  s.x[1] = {0, 0.4, 0}, s.x[2] = {0.3, 0.1, 0};
  s.x[3] = {-0.5 * std::cos(phi), 0.2, 0.5 * std::sin(phi)};
  s.wants_tangent = true;
  return s;
}

Dual<12> dual_energy(const State<4>& s, const Bending::Data& d) {
  Points<Dual<12>, 4> x;
  for (int i = 0; i < 12; ++i) {
    const auto node = static_cast<std::size_t>(i / 3);
    x[node][i % 3] = Dual<12>::variable(s.x[node][i % 3], i);
  }
  return Bending::Elastic::oracle(kStiffTwine, d, kSeaWater, x);
}

void expect_matches(const State<4>& s, const Bending::Data& d) {
  Local<4> found;
  ASSERT_EQ(Bending::Elastic::evaluate(kStiffTwine, d, s, found), Status::ok);
  const Dual<12> e = dual_energy(s, d);
  double force = 0, tangent = 0, error = 0;
  for (const double g : e.gradient) force = std::max(force, std::abs(g));
  for (const double h : e.hessian) tangent = std::max(tangent, std::abs(h));
  EXPECT_NEAR(found.energy, e.value, 1e-13 * Bending::flat(kStiffTwine, d).kappa + 1e-12 * std::abs(e.value));
  for (std::size_t r = 0, k = 0; r < 12; ++r) {
    EXPECT_NEAR(found.force[r / 3][static_cast<int>(r % 3)], e.gradient[r], 1e-11 * force + 1e-14 * tangent);
    for (std::size_t c = 0; c <= r; ++c, ++k) {
      error = std::max(error, std::abs(found.tangent[r][c] - e.hessian[k]));
      EXPECT_NEAR(found.tangent[r][c], found.tangent[c][r], 1e-12 * tangent);
    }
  }
  EXPECT_LT(error, 1e-11 * tangent);
}

TEST(NettingBending, MatchesItsOracleWhenFlatBentAndNearlyFolded) {
  for (const double phi : {0.0, 1e-3, 0.4, 1.5, 2.8, 3.07, 3.09, 3.13}) expect_matches(folded(phi), kPair);
}

TEST(NettingBending, MatchesItsOracleAnywhere) {
  std::mt19937_64 random(5);
  for (int k = 0; k < 50; ++k) {
    State<4> s;
    s.wants_tangent = true;
    for (auto& x : s.x)
      for (int axis = 0; axis < 3; ++axis) x[axis] = uniform(random, -1, 1);
    expect_matches(s, kPair);
  }
}

TEST(NettingBending, IsThatOfTheTwinesThatCrossTheEdge) {  // 4 u twines, square to it: k b = 4 EI
  EXPECT_NEAR(Bending::flat(kStiffTwine, kPair).kappa, 4 * (4 * 2e-3) / (0.3 + 0.5), 1e-15);
  Local<4> found;
  ASSERT_EQ(Bending::Elastic::evaluate(kStiffTwine, kPair, folded(0.6), found), Status::ok);
  const double energy = -4 * (4 * 2e-3) / 0.8 * std::log((1 + std::cos(0.6)) / 2);
  EXPECT_NEAR(found.energy, energy, 2e-6 * energy);  // the difference is the effect of δ on open meshes
}

TEST(NettingBending, TurnsWithTheCoupleOverTheRadius) {  // moment of the force on d about the edge
  Local<4> found;
  ASSERT_EQ(Bending::Elastic::evaluate(kStiffTwine, kPair, folded(0.6), found), Status::ok);
  const double radius = 0.8 / (4 * std::tan(0.3));
  const Vec3<double> away{0.5 * std::sin(0.6), 0, 0.5 * std::cos(0.6)};  // d moves so per radian
  EXPECT_NEAR(dot(found.force[3], away), 4 * 2e-3 / radius, 2e-6 * 4 * 2e-3 / radius);
}

TEST(NettingBending, MeasuresObliqueEdgesInTheMeshesItIsToldOf) {
  // The edge (1, 1) runs along the N direction of knots. In meshes of half angle β its length is 2 cos β
  // bars, and one twine of each direction crosses it at the angle β.
  const Bending::Data pair{{0, 1, 1, 0}, {0, 1, 0, 1}, {0.1, 0.1}};
  for (const double beta : {0.3, std::numbers::pi / 4, 1.1}) {
    const double altitude = 0.1 * std::sin(beta), kb = 2 * 2e-3 * std::pow(std::sin(beta), 2);
    EXPECT_NEAR(Bending::flat({2e-3, beta}, pair).kappa, 4 * kb / (2 * altitude), 1e-14) << beta;
  }
}

TEST(NettingBending, IsFiniteWhereNettingIsFoldedUponItself) {
  Local<4> found;
  ASSERT_EQ(Bending::Elastic::evaluate(kStiffTwine, kPair, folded(std::numbers::pi), found), Status::ok);
  EXPECT_NEAR(found.energy, Bending::flat(kStiffTwine, kPair).kappa * (std::log(1e3) + 1.5), 1e-3);
}

TEST(NettingBending,
     FadesOutOfMeshesThatClose) {  // compared with a curve that is smooth through zero
  for (const double width : {1e-2, 1e-3, 1e-4, 0.0, -1e-4, -1e-2}) {
    State<4> s = folded(0.6);
    s.x[2].x = width * 0.3;
    expect_matches(s, kPair);
  }
}

TEST(NettingBending, IsNothingInOnePoint) {
  Local<4> found;
  ASSERT_EQ(Bending::Elastic::evaluate(kStiffTwine, kPair, State<4>{}, found), Status::ok);
  EXPECT_EQ(found.energy, 0);
}

TEST(NettingBending, RefusesTrianglesThatHoldNoNetting) {
  EXPECT_THROW(Bending::check(kStiffTwine, {{0, 0, 0, -5}, {0, 4, 1, 2}, {0.1, 0.1}}), std::invalid_argument);
}

}  // namespace
