// SPDX-License-Identifier: BSD-3-Clause
//
// rope/bending without rope/bar, whose stiffness would hide an error in the tangent of bending. The bending
// is compared with its energy differentiated by dual numbers, and with the moment of the trawl-gear paper's
// eq. (1).
#include "plugins/rope/rope_bending.hpp"

#include "tests/unit/plugins/rope/turned_bars.hpp"

namespace {

using namespace netloft;
using rope::Bending;

const Bending::Parameters kBentRope{3.7};
const Bending::Data kBars{{0.8, 1.1}};

State<3> at(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  State<3> s;
  s.x = {a, b, c}, s.wants_tangent = true;
  return s;
}

struct Errors {
  double energy, force, tangent;
};

Errors compare(const State<3>& s) {
  Points<Dual<9>, 3> x;
  for (int i = 0; i < 9; ++i)
    x[static_cast<std::size_t>(i / 3)][i % 3] =
        Dual<9>::variable(s.x[static_cast<std::size_t>(i / 3)][i % 3], i);
  const auto e = Bending::Elastic::oracle(kBentRope, kBars, kSeaWater, x);
  Local<3> out;
  EXPECT_EQ(Bending::Elastic::evaluate(kBentRope, kBars, s, out), Status::ok);
  double force = 0, tangent = 0, force_size = 0, tangent_size = 0;
  std::size_t k = 0;
  for (int r = 0; r < 9; ++r) {
    const double f = e.gradient[static_cast<std::size_t>(r)];
    force = std::max(force, std::abs(out.force[static_cast<std::size_t>(r / 3)][r % 3] - f));
    force_size = std::max(force_size, std::abs(f));
    for (int c = 0; c <= r; ++c, ++k) {
      tangent = std::max(
          {tangent, std::abs(out.tangent[r][c] - e.hessian[k]), std::abs(out.tangent[c][r] - e.hessian[k])});
      tangent_size = std::max(tangent_size, std::abs(e.hessian[k]));
    }
  }
  return {std::abs(out.energy - e.value) / e.value, force / force_size, tangent / tangent_size};
}

TEST(RopeBending, MatchesItsOracleAtEveryAngle) {
  for (const double phi : {0.01, 0.1, 0.5, 1.0, 1.6, 2.5, 3.0, 3.1}) {
    const Errors e = compare(turned(phi, 0.9, 0.7));
    EXPECT_LT(e.energy, 1e-10) << phi;
    EXPECT_LT(e.force, 1e-10) << phi;
    EXPECT_LT(e.tangent, 1e-10) << phi;
  }
}

TEST(RopeBending, MatchesItsOracleAnywhere) {
  std::mt19937_64 random(7);
  for (int k = 0; k < 200; ++k) {
    Vec3<double> x[3];
    for (auto& p : x) p = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
    const Errors e = compare(at(x[0], x[1], x[2]));
    EXPECT_LT(std::max({e.energy, e.force, e.tangent}), 1e-9) << k;
  }
}

/// Returns dE/dφ for a motion of the last node on its circle: force times lever arm.
double moment(double phi) {
  const State<3> s = turned(phi);
  Local<3> out;
  EXPECT_EQ(Bending::Elastic::evaluate(kBentRope, kBars, s, out), Status::ok);
  const State<3> further = turned(phi + std::numbers::pi / 2);
  const Vec3<double> tangential = (1 / 1.1) * (further.x[2] - further.x[1]);
  return 1.1 * dot(out.force[2], tangential);
}

TEST(RopeBending, HasTheMomentEIOverR) {
  for (const double phi : {1e-5, 1e-3, 0.2, 1.0, 2.0, 3.0})
    EXPECT_NEAR(moment(phi) / (3.7 * 4 * std::tan(phi / 2) / 1.9), 1, 1e-9) << phi;
}

TEST(RopeBending, KeepsItsDigitsInANearlyStraightRope) {
  const double phi = 1e-7;
  Local<3> out;
  ASSERT_EQ(Bending::Elastic::evaluate(kBentRope, kBars, turned(phi), out), Status::ok);
  EXPECT_NEAR(out.energy / (0.5 * 3.7 * 2 / 1.9 * phi * phi), 1, 1e-7);  // ½ (2 EI/(L₁ + L₂)) φ²
}

TEST(RopeBending, IsStiffAcrossAStraightRope) {
  Local<3> out;
  ASSERT_EQ(Bending::Elastic::evaluate(kBentRope, kBars, at({0, 0, 0}, {0.8, 0, 0}, {1.9, 0, 0}), out),
            Status::ok);
  EXPECT_EQ(out.energy, 0);
  const double k = 2 * 3.7 / 1.9;  // φ = z₂/1.1 − z₁ (1/0.8 + 1/1.1)
  EXPECT_NEAR(out.tangent[8][8], k / (1.1 * 1.1), 1e-12);
  EXPECT_NEAR(out.tangent[5][8], -k * (1 / 0.8 + 1 / 1.1) / 1.1, 1e-12);
  EXPECT_EQ(out.tangent[6][6], 0);
}

TEST(RopeBending, IsOutsideItsDomainFoldedBackAndWithoutLength) {
  Local<3> out;
  EXPECT_EQ(Bending::Elastic::evaluate(kBentRope, kBars, at({0, 0, 0}, {1, 0, 0}, {0.2, 0, 0}), out),
            Status::outside_domain);
  EXPECT_EQ(Bending::Elastic::evaluate(kBentRope, kBars, at({0, 0, 0}, {0, 0, 0}, {1, 0, 0}), out),
            Status::outside_domain);
}

TEST(RopeBending, AsksNothingOfALimpRope) {
  Local<3> out;
  EXPECT_EQ(Bending::Elastic::evaluate({0}, kBars, at({0, 0, 0}, {0, 0, 0}, {0, 0, 0}), out), Status::ok);
  EXPECT_EQ(out.energy, 0);
}

}  // namespace
