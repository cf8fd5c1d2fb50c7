// SPDX-License-Identifier: BSD-3-Clause
//
// lumped/net compared with its energies differentiated by dual numbers, and with the same number of parallel
// ropes. The formulas of one bar are tested in tests/unit/plugins/rope.
#include "plugins/lumped/net.hpp"

#include "plugins/hydro/morison.hpp"
#include "plugins/rope/bar.hpp"
#include "tests/unit/plugins/kernel_oracle.hpp"

namespace {

using namespace netloft;
using hydro::Morison;
using lumped::Net;
using rope::Bar;

constexpr Water kWater{1025, 9.81, 1.19e-6};
constexpr double kLength = 1.5, kTwines = 2.5;
const Net::Parameters kTwine{1e4, 1, 0.01, 2000, 30, 1, 0, 0.1};
const Morison::Parameters kLaw{1.2, 0.08, 1};
const std::vector<Net::Data> kBundles(kLanes, Net::Data{kLength, kTwines});

/// Bars in any direction, with lengths between `least` and `most` times the unstretched length.
void place_bars(TestTile<2>& tile, double least, double most) {
  std::mt19937_64 random(1);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Vec3<double> d{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0.1, 1)};
    const double scale = kLength * uniform(random, least, most) / norm(d);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      tile.x[a * kLanes + lane] = uniform(random, -1, 1);
      tile.x[(a + 3) * kLanes + lane] = tile.x[a * kLanes + lane] + scale * d[axis];
    }
  }
}

template <class Term>
void expect_matches_oracle(double least, double most, bool constant) {
  TestTile<2> tile(kWater);
  place_bars(tile, least, most);
  expect_kernel_matches_oracle<Net, Term>(kTwine, kBundles, kWater, tile, constant);
}

TEST(LumpedNet, MatchesItsOracleWhenTaut) { expect_matches_oracle<Net::Elastic>(1.1, 2, false); }
TEST(LumpedNet, MatchesItsOracleWhenSlack) { expect_matches_oracle<Net::Elastic>(0.1, 0.9, false); }
TEST(LumpedNet, WeighsWhatItsOracleSays) { expect_matches_oracle<Net::Weight>(0.5, 2, true); }

/// A tile of 64 bars that move in a sheared current, with room for the full tangent.
struct MovingTile {
  MovingTile() {
    std::mt19937_64 random(7);
    for (std::size_t i = 0; i < 6 * kLanes; ++i) {
      x[i] = uniform(random, -1, 1), v[i] = uniform(random, -1, 1), a[i] = uniform(random, -5, 5);
      current[i] = uniform(random, 0, 2), dz[i] = uniform(random, -0.1, 0.1);
    }
    t.size = sizeof t, t.count = NETLOFT_LANES;
    t.want = NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT;
    t.cu = 1, t.cv = 0.7, t.ca = 0.3;
    t.water_density = kWater.density, t.gravity = kWater.gravity, t.water_viscosity = kWater.viscosity;
    t.x = x, t.v = v, t.a = a, t.current = current, t.current_dz = dz;
    t.force = force, t.tangent = tangent;
  }
  double x[6 * kLanes], v[6 * kLanes], a[6 * kLanes], current[6 * kLanes], dz[6 * kLanes];
  double force[6 * kLanes] = {}, tangent[36 * kLanes] = {};
  netloft_tile t{};
};

template <class E>
Family<E> in_water(const typename E::Parameters& p, const std::vector<typename E::Data>& data) {
  auto f = make_family<E>(p, data);
  f.laws_.push_back({NETLOFT_TWINE_LAW, 0, &kLaw, &detail::evaluate_law<Morison>});
  return f;
}

Bar::Parameters as_rope(const Net::Parameters& p) {
  Bar::Parameters r{p.EA, p.EA_compression, p.diameter, p.density};
  r.damping = p.damping, r.loss_factor = p.loss_factor, r.added_mass = p.added_mass;
  return r;
}
const Bar::Parameters kRope = as_rope(kTwine);
const std::vector<Bar::Data> kRopes(kLanes, Bar::Data{kLength});

template <class NetTerm, class BarTerm>
void expect_as_many_ropes() {
  MovingTile net, rope;
  ASSERT_EQ(NetTerm::tile(in_water<Net>(kTwine, kBundles), net.t), Status::ok);
  ASSERT_EQ(BarTerm::tile(in_water<Bar>(kRope, kRopes), rope.t), Status::ok);
  const auto expect_equal = [](const auto& found, const auto& one) {
    for (std::size_t k = 0; k < std::size(found); ++k)
      EXPECT_NEAR(found[k], kTwines * one[k], 1e-13 * (1 + std::abs(kTwines * one[k]))) << k;
  };
  expect_equal(net.force, rope.force);
  expect_equal(net.tangent, rope.tangent);
}

TEST(LumpedNet, IsDraggedAsManyRopes) { expect_as_many_ropes<Net::Drag, Bar::Drag>(); }
TEST(LumpedNet, IsDampedAsManyRopes) { expect_as_many_ropes<Net::Damping, Bar::Damping>(); }
TEST(LumpedNet, LosesAsManyRopes) { expect_as_many_ropes<Net::Loss, Bar::Loss>(); }
TEST(LumpedNet, IsAsInertAsManyRopes) { expect_as_many_ropes<Net::Inertia, Bar::Inertia>(); }

TEST(LumpedNet, ReportsTheTensionOfOneTwineAndTheDragOfAll) {
  const State<2> s{.x = {Vec3<double>{0, 0, 0}, Vec3<double>{0, 1.1 * kLength, 0}}};
  EXPECT_NEAR(Net::stretch(kTwine, kBundles[0], s).T, 1000, 1e-9);  // EA x 10 %
  const MovingTile m;
  double net[kLanes], rope[kLanes];
  Net::drag_of(in_water<Net>(kTwine, kBundles), m.t, net);
  Bar::drag_of(in_water<Bar>(kRope, kRopes), m.t, rope);
  for (std::size_t i = 0; i < kLanes; ++i) EXPECT_NEAR(net[i], kTwines * rope[i], 1e-12 * net[i]);
}

TEST(LumpedNet, RefusesBarsWithoutLengthOrTwines) {
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(Net::check(kTwine, {wrong, 1}), std::invalid_argument) << wrong;
    EXPECT_THROW(Net::check(kTwine, {1, wrong}), std::invalid_argument) << wrong;
  }
}

}  // namespace
