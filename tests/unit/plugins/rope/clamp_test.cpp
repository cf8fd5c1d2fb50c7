// SPDX-License-Identifier: BSD-3-Clause
//
// rope/clamp, and rope/bending by the circle through three nodes, compared with their energies differentiated
// by dual numbers, and with moments in closed form.
#include "plugins/rope/clamp.hpp"

#include "plugins/rope/mirror.hpp"
#include "plugins/rope/rope_bending.hpp"
#include "tests/unit/plugins/rope/turned_bars.hpp"

namespace {

using namespace netloft;
using rope::Bending;
using rope::Clamp;
using rope::Mirror;

constexpr std::array<double, 2> kLengths{0.8, 1.1};

/// Largest error of force and tangent over the largest entry of each.
template <class E>
double error_of(const typename E::Parameters& p, const State<3>& s) {
  Points<Dual<9>, 3> x;
  for (int i = 0; i < 9; ++i)
    x[static_cast<std::size_t>(i / 3)][i % 3] =
        Dual<9>::variable(s.x[static_cast<std::size_t>(i / 3)][i % 3], i);
  const auto e = E::Elastic::oracle(p, {kLengths}, kSeaWater, x);
  Local<3> out;
  EXPECT_EQ(E::Elastic::evaluate(p, {kLengths}, s, out), Status::ok);
  double force = 0, tangent = 0, force_size = 0, tangent_size = 0;
  std::size_t k = 0;
  for (int r = 0; r < 9; ++r) {
    const double f = e.gradient[static_cast<std::size_t>(r)];
    force = std::max(force, std::abs(out.force[static_cast<std::size_t>(r / 3)][r % 3] - f));
    force_size = std::max(force_size, std::abs(f));
    for (int c = 0; c <= r; ++c, ++k) {
      tangent = std::max(tangent, std::abs(out.tangent[r][c] - e.hessian[k]));
      tangent_size = std::max(tangent_size, std::abs(e.hessian[k]));
    }
  }
  EXPECT_NEAR(out.energy, e.value, 1e-12 * (1 + std::abs(e.value)));
  return std::max(force / force_size, tangent / tangent_size);
}

TEST(RopeClamp, MatchesItsOracleAtEveryAngle) {
  for (const auto curvature : {Clamp::of_bars, Clamp::of_nodes})
    for (const double phi : {0.2, 0.6, 1.0, 1.5, 2.5, 3.0})
      EXPECT_LT(error_of<Clamp>({3.7, 1.1, curvature}, turned(phi, 0.9, 0.7)), 1e-9) << phi;
}

TEST(RopeClamp, HasNoMomentAtItsOwnAngle) {
  for (const auto curvature : {Clamp::of_bars, Clamp::of_nodes}) {
    Local<3> out;
    ASSERT_EQ(Clamp::Elastic::evaluate({3.7, 1.1, curvature}, {kLengths}, turned(1.1), out), Status::ok);
    EXPECT_NEAR(out.energy, 0, 1e-14);
    for (const auto& f : out.force) EXPECT_LT(norm(f), 1e-14);
  }
}

/// Moment about the middle node: force on the last node times its arm.
double moment(const Clamp::Parameters& p, double phi) {
  Local<3> out;
  EXPECT_EQ(Clamp::Elastic::evaluate(p, {kLengths}, turned(phi), out), Status::ok);
  return norm(out.force[2]) * kLengths[1];
}

TEST(RopeClamp, HasTheMomentOfItsCircle) {
  const double a = kLengths[0], b = kLengths[1], delta = 0.7;
  EXPECT_NEAR(moment({3.7, 1.1, Clamp::of_bars}, 1.1 + delta), 4 * 3.7 / (a + b) * std::tan(delta / 2),
              1e-12);
  EXPECT_NEAR(moment({3.7, 1.1, Clamp::of_nodes}, 1.1 + delta),
              2 * 3.7 * std::sin(delta) / std::sqrt(a * a + b * b + 2 * a * b * std::cos(delta)), 1e-12);
}

TEST(RopeClamp, BendsLikeARopeWhereItIsStraightAtRest) {
  for (const double phi : {0.0, 1e-6, 0.4, 2.0}) {
    Local<3> clamp, rope;
    ASSERT_EQ(Clamp::Elastic::evaluate({3.7, 0, Clamp::of_nodes}, {kLengths}, turned(phi), clamp),
              Status::ok);
    ASSERT_EQ(Bending::Elastic::evaluate({3.7, Bending::of_nodes}, {kLengths}, turned(phi), rope),
              Status::ok);
    EXPECT_EQ(clamp.energy, rope.energy);
    for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(norm(clamp.force[n] - rope.force[n]), 0);
  }
}

TEST(RopeClamp, HasNoPlaneToTurnBarsInLineIn) {
  Local<3> in_line, folded;
  ASSERT_EQ(Clamp::Elastic::evaluate({3.7, 1.1, 0}, {kLengths}, turned(0), in_line), Status::ok);
  for (const auto& f : in_line.force) EXPECT_EQ(norm(f), 0);
  EXPECT_EQ(Clamp::Elastic::evaluate({3.7, 1.1, 0}, {kLengths}, turned(std::acos(-1.0)), folded),
            Status::outside_domain);
}

/// A bar that begins on the plane y = 0 is compared with rope/bending between the bar and its image.
TEST(RopeMirror, IsHalfOfTheBendingBetweenABarAndItsImage) {
  for (const auto curvature : {Mirror::of_bars, Mirror::of_nodes}) {
    const Vec3<double> on_plane{1, 0, -3}, end{1.3, 0.5, -3.2}, image{1.3, -0.5, -3.2};
    State<3> pair;
    pair.x = {end, on_plane, image};
    Local<3> whole;
    const double L = norm(end - on_plane);
    ASSERT_EQ(Bending::Elastic::evaluate({3.7, curvature}, {{L, L}}, pair, whole), Status::ok);
    Points<Dual<6>, 2> x;
    for (int i = 0; i < 6; ++i)
      x[static_cast<std::size_t>(i / 3)][i % 3] = Dual<6>::variable((i < 3 ? on_plane : end)[i % 3], i);
    const auto half = Mirror::Elastic::energy({3.7, 1, curvature}, {L}, kSeaWater, x);
    EXPECT_NEAR(half.value, 0.5 * whole.energy, 1e-13);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(half.gradient[static_cast<std::size_t>(3 + axis)], whole.force[0][axis], 1e-12);
      if (axis != 1)
        EXPECT_NEAR(half.gradient[static_cast<std::size_t>(axis)], 0.5 * whole.force[1][axis], 1e-12);
    }
  }
}

TEST(RopeMirror, RefusesABarInItsPlaneOrBeyond) {
  const Points<double, 2> x{{{0, 0, 0}, {1, 0, 1}}};
  EXPECT_THROW(Mirror::Elastic::energy({1, 1}, {1}, kSeaWater, x), OutsideDomain);
  const Points<double, 2> beyond{{{0, 0, 0}, {1, -0.1, 1}}};
  EXPECT_THROW(Mirror::Elastic::energy({1, 1}, {1}, kSeaWater, beyond), OutsideDomain);
  EXPECT_NO_THROW(Mirror::Elastic::energy({1, 1, 0, 1}, {1}, kSeaWater, beyond));
}

TEST(RopeBendingByNodes, MatchesItsOracleAtEveryAngle) {
  for (const double phi : {0.01, 0.5, 1.6, 3.0})
    EXPECT_LT(error_of<Bending>({3.7, Bending::of_nodes}, turned(phi, 0.9, 0.7)), 1e-10) << phi;
}

}  // namespace
