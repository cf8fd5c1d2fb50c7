// SPDX-License-Identifier: BSD-3-Clause
//
// Drag, damping and inertia of rope/bar: forces and all three tangents compared with the formulas in dual
// numbers, and with values by hand.
#include "plugins/hydro/morison.hpp"
#include "plugins/rope/bar.hpp"

#include "tests/unit/plugins/kernel_oracle.hpp"

namespace {

using namespace netloft;
using hydro::Morison;
using rope::Bar;

constexpr Water kViscousWater{1025, 9.81, 1.19e-6};
constexpr double kLength = 1.3, kShear[3] = {0.05, -0.02, 0.01};  // [m], [1/s]
const Morison::Parameters kLaw{1.2, 0.08, 1};

Bar::Parameters make_rope() {
  Bar::Parameters p{1e5, 1e2, 0.02, 1400};
  p.damping = 300, p.added_mass = 1;
  return p;
}
const Bar::Parameters kDampedRope = make_rope();

template <class T>
using Ends = Points<T, 2>;

/// The state of one bar, with everything that a term may read. The current is linear in z.
template <class T>
struct Sight {
  Ends<T> x, v, a, current;
};

template <class T>
Vec3<T> chord(const Sight<T>& s) {
  const Vec3<T> w = s.x[1] - s.x[0];
  return (1.0 / norm(w)) * w;
}

struct DragOracle {
  template <class T>
  static Ends<T> force(const Sight<T>& s) {
    Flow<T> f;
    f.flow = 0.5 * (s.current[0] + s.current[1]) - 0.5 * (s.v[0] + s.v[1]);
    f.direction = chord(s), f.diameter = kDampedRope.diameter;
    f.density = kViscousWater.density, f.viscosity = kViscousWater.viscosity;
    const Vec3<T> half = (-0.5 * kLength) * Morison::force(kLaw, f);
    return {half, half};
  }
};
struct DampingOracle {
  template <class T>
  static Ends<T> force(const Sight<T>& s) {
    const Vec3<T> t = chord(s), pull = (kDampedRope.damping / kLength * dot(t, s.v[1] - s.v[0])) * t;
    return {-pull, pull};
  }
};
struct InertiaOracle {
  template <class T>
  static Ends<T> force(const Sight<T>& s) {
    const double half = 0.5 * std::numbers::pi / 4 * kDampedRope.diameter * kDampedRope.diameter * kLength;
    const double added = half * kDampedRope.added_mass * kViscousWater.density;
    Ends<T> r;
    for (std::size_t p = 0; p < 2; ++p)
      r[p] = (half * kDampedRope.density + added) * s.a[p] - (added * dot(chord(s), s.a[p])) * chord(s);
    return r;
  }
};

/// A tile of 64 bars that move in a sheared current, with room for the full tangent.
struct MovingTile {
  MovingTile() {
    std::mt19937_64 random(3);
    for (std::size_t i = 0; i < 6 * kLanes; ++i) {
      x[i] = uniform(random, -1, 1) - (i / kLanes % 3 == 2 ? 10 : 0);
      v[i] = uniform(random, -1, 1), a[i] = uniform(random, -5, 5), dz[i] = kShear[i / kLanes % 3];
    }
    for (std::size_t i = 0; i < 6 * kLanes; ++i) {
      const std::size_t z = (i / kLanes / 3 * 3 + 2) * kLanes + i % kLanes;
      current[i] = 1 + dz[i] * x[z];
    }
    t.size = sizeof t, t.count = NETLOFT_LANES;
    t.want = NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT;
    t.water_density = kViscousWater.density, t.gravity = kViscousWater.gravity,
    t.water_viscosity = kViscousWater.viscosity;
    t.x = x, t.v = v, t.a = a, t.current = current, t.current_dz = dz;
    t.force = force, t.tangent = tangent;
  }
  double x[6 * kLanes], v[6 * kLanes], a[6 * kLanes], current[6 * kLanes], dz[6 * kLanes];
  double force[6 * kLanes] = {}, tangent[36 * kLanes] = {};
  netloft_tile t{};
};

enum class By { position, velocity, acceleration };

/// Lane i in dual numbers; the variables are its positions, velocities or accelerations. The current depends
/// on the positions.
Sight<Dual<6, 1>> seen(const MovingTile& m, std::size_t i, By by) {
  using T = Dual<6, 1>;
  Sight<T> s;
  const auto fill = [i](const double* from, bool varies, Ends<T>& to) {
    for (int d = 0; d < 6; ++d) {
      const double value = from[static_cast<std::size_t>(d) * kLanes + i];
      to[static_cast<std::size_t>(d / 3)][d % 3] = varies ? T::variable(value, d) : T(value);
    }
  };
  fill(m.x, by == By::position, s.x);
  fill(m.v, by == By::velocity, s.v);
  fill(m.a, by == By::acceleration, s.a);
  for (std::size_t n = 0; n < 2; ++n)
    for (int axis = 0; axis < 3; ++axis) s.current[n][axis] = 1 + kShear[axis] * s.x[n].z;
  return s;
}

Family<Bar> family_in_water() {
  auto f = make_family<Bar>(kDampedRope, std::vector<Bar::Data>(kLanes, Bar::Data{kLength}));
  f.laws_.push_back({NETLOFT_TWINE_LAW, 0, &kLaw, &detail::evaluate_law<Morison>});
  return f;
}

template <class Term, class Oracle>
void expect_force_and_tangent(By by) {
  const Family<Bar> family = family_in_water();
  MovingTile m;
  m.t.cu = by == By::position, m.t.cv = by == By::velocity, m.t.ca = by == By::acceleration;
  ASSERT_EQ(Term::tile(family, m.t), Status::ok);
  for (std::size_t i = 0; i < kLanes; ++i) {
    const auto expected = Oracle::force(seen(m, i, by));
    std::array<double, 6> force{};
    std::array<double, 36> tangent{};
    for (std::size_t d = 0; d < 6; ++d) {
      const auto& r = expected[d / 3][static_cast<int>(d % 3)];
      force[d] = r.value;
      for (std::size_t c = 0; c < 6; ++c) tangent[6 * d + c] = r.gradient[c];
    }
    EXPECT_LT(relative_error(m.force, force, i), 1e-12) << "force of lane " << i;
    EXPECT_LT(relative_error(m.tangent, tangent, i), 1e-12) << "tangent of lane " << i;
  }
}

TEST(RopeDrag, MatchesItsFormulaAndItsDerivativeInPosition) {
  expect_force_and_tangent<Bar::Drag, DragOracle>(By::position);
}
TEST(RopeDrag, MatchesItsDerivativeInVelocity) {
  expect_force_and_tangent<Bar::Drag, DragOracle>(By::velocity);
}
TEST(RopeDamping, MatchesItsFormulaAndItsDerivativeInPosition) {
  expect_force_and_tangent<Bar::Damping, DampingOracle>(By::position);
}
TEST(RopeDamping, MatchesItsDerivativeInVelocity) {
  expect_force_and_tangent<Bar::Damping, DampingOracle>(By::velocity);
}
TEST(RopeInertia, MatchesItsFormulaAndItsDerivativeInPosition) {
  expect_force_and_tangent<Bar::Inertia, InertiaOracle>(By::position);
}
TEST(RopeInertia, MatchesItsDerivativeInAcceleration) {
  expect_force_and_tangent<Bar::Inertia, InertiaOracle>(By::acceleration);
}

/// One upright bar of its unstretched length, in a current of 1.5 m/s along x.
struct Upright : MovingTile {
  Upright() {
    for (std::size_t i = 0; i < 6 * kLanes; ++i) x[i] = v[i] = a[i] = dz[i] = 0;
    x[5 * kLanes] = kLength;
    for (std::size_t i = 0; i < 6 * kLanes; ++i) current[i] = i / kLanes % 3 == 0 ? 1.5 : 0;
    t.count = 1, t.want = NETLOFT_WANT_FORCE, t.tangent = nullptr;
  }
};

TEST(RopeDrag, PushesAnUprightRopeWithTheCurrent) {
  Upright m;
  ASSERT_EQ(Bar::Drag::tile(family_in_water(), m.t), Status::ok);
  const double half = 0.5 * 27.675 * kLength;  // ½ 1025 0.02 1.2 1.5² per metre
  EXPECT_NEAR(m.force[0], -half, 1e-12);       // the residual is minus the force
  EXPECT_NEAR(m.force[3 * kLanes], -half, 1e-12);
  double drag = 0, angle = 0;
  Bar::drag_of(family_in_water(), m.t, &drag);
  Bar::angle_of(family_in_water(), m.t, &angle);
  EXPECT_NEAR(drag, 2 * half, 1e-12);
  EXPECT_NEAR(angle, std::numbers::pi / 2, 1e-15);
}

TEST(RopeDrag, IsReportedAsZeroWhereNoLawWasNeeded) {
  Upright m;
  auto f = family_in_water();
  f.laws_[0] = {};
  double drag = 1;
  Bar::drag_of(f, m.t, &drag);
  EXPECT_EQ(drag, 0);
}

TEST(RopeInertia, FeelsAddedMassAcrossAndNotAlong) {
  Upright m;
  m.a[0] = 1, m.a[2 * kLanes] = 1;
  ASSERT_EQ(Bar::Inertia::tile(family_in_water(), m.t), Status::ok);
  const double half = 0.5 * std::numbers::pi * 1e-4 * kLength;  // half the volume
  EXPECT_NEAR(m.force[0], half * (1400 + 1025), 1e-12);
  EXPECT_NEAR(m.force[2 * kLanes], half * 1400, 1e-12);
}

TEST(RopeDamping, ResistsTheRateOfStretch) {
  Upright m;
  m.v[5 * kLanes] = 0.1;
  ASSERT_EQ(Bar::Damping::tile(family_in_water(), m.t), Status::ok);
  EXPECT_NEAR(m.force[5 * kLanes], 300 * 0.1 / kLength, 1e-12);
  EXPECT_NEAR(m.force[2 * kLanes], -300 * 0.1 / kLength, 1e-12);
}

/// The damping (1), (2) of loss.hpp for any number type.
struct LossOracle {
  static constexpr double kLoss = 1e5 * 0.2 / (2 * std::numbers::pi * 4);  // EA η/(2π f)
  template <class T>
  static Ends<T> force(const Sight<T>& s) {
    const T l = norm(s.x[1] - s.x[0]), y = (l * (1 / kLength) - T(1)) * T(1e4);
    const T share = y < T(0) ? T(0) : y > T(1) ? T(1) : y * y * (T(3) - T(2) * y);
    const Vec3<T> t = chord(s), pull = (kLoss / kLength * share * dot(t, s.v[1] - s.v[0])) * t;
    return {-pull, pull};
  }
};

TEST(RopeLoss, MatchesItsFormulaAndItsDerivativesAsItTightens) {
  Family<Bar> family = family_in_water();
  Bar::Parameters p = kDampedRope;
  p.loss_factor = 0.2, p.loss_frequency = 4;
  for (std::size_t i = 0; i < kLanes; ++i) Bar::pack(p, {kLength}, family.lanes_[0], i);
  for (const By by : {By::position, By::velocity}) {
    MovingTile m;
    for (std::size_t i = 0; i < kLanes; ++i) {  // slack in some lanes; in most, the loss is between zero and
                                                // its full value
      const double l = kLength * (1 + 1e-4 * (-0.1 + 1.3 * double(i) / kLanes));
      double w[3], now = 0;
      for (std::size_t k = 0; k < 3; ++k)
        w[k] = m.x[(k + 3) * kLanes + i] - m.x[k * kLanes + i], now += w[k] * w[k];
      for (std::size_t k = 0; k < 3; ++k)
        m.x[(k + 3) * kLanes + i] = m.x[k * kLanes + i] + w[k] * l / std::sqrt(now);
    }
    m.t.cu = by == By::position, m.t.cv = by == By::velocity, m.t.ca = 0;
    ASSERT_EQ(Bar::Loss::tile(family, m.t), Status::ok);
    for (std::size_t i = 0; i < kLanes; ++i) {
      const auto expected = LossOracle::force(seen(m, i, by));
      for (std::size_t d = 0; d < 6; ++d) {
        const auto& r = expected[d / 3][static_cast<int>(d % 3)];
        EXPECT_NEAR(m.force[d * kLanes + i], r.value, 1e-9 * LossOracle::kLoss) << i;
        for (std::size_t c = 0; c < 6; ++c)
          EXPECT_NEAR(m.tangent[(6 * d + c) * kLanes + i], r.gradient[c], 1e-5 * LossOracle::kLoss) << i;
      }
    }
  }
}

TEST(RopeLoss, IsThatOfTheDampingWhenTautAndNothingWhenSlack) {
  Family<Bar> family = family_in_water();
  Bar::Parameters p = kDampedRope;
  p.loss_factor = 0.1;
  Bar::pack(p, {kLength}, family.lanes_[0], 0);
  Upright m;
  m.v[5 * kLanes] = 0.1;
  m.x[5 * kLanes] = 1.001 * kLength;
  ASSERT_EQ(Bar::Loss::tile(family, m.t), Status::ok);
  EXPECT_NEAR(m.force[5 * kLanes], 1e5 * 0.1 / (20 * std::numbers::pi) * 0.1 / kLength, 1e-10);
  m.force[5 * kLanes] = 0, m.x[5 * kLanes] = 0.999 * kLength;
  ASSERT_EQ(Bar::Loss::tile(family, m.t), Status::ok);
  EXPECT_EQ(m.force[5 * kLanes], 0);
}

TEST(RopeLoss, IsNothingWhereRopeRunsOffADrumAsItIsStretched) {
  static const double table[] = {0, 1, 10, 3};  // a rope whose length grows threefold in 10 s
  Family<Bar> family = family_in_water();
  Bar::Parameters p = kDampedRope;
  p.loss_factor = 0.1, p.length_share.rows = 2, p.length_share.values = table;
  Bar::pack(p, {kLength}, family.lanes_[0], 0);
  family.lanes_[0].changes = true;
  Upright m;
  m.t.time = 5;  // the rope is then twice as long, and grows by a tenth of this length per second
  m.x[5 * kLanes] = 1.001 * 2 * kLength;
  m.v[5 * kLanes] = 1.001 * 0.2 * kLength;
  ASSERT_EQ(Bar::Loss::tile(family, m.t), Status::ok);
  EXPECT_NEAR(m.force[5 * kLanes], 0, 1e-10);
  m.v[5 * kLanes] = 0;
  ASSERT_EQ(Bar::Loss::tile(family, m.t), Status::ok);
  EXPECT_NEAR(m.force[5 * kLanes], -0.1 * 1.001 * 1e5 * 0.1 / (20 * std::numbers::pi),
              1e-9);  // the rope is held while it is paid out
}

Bar::Parameters make_winch() {
  Bar::Parameters p = kDampedRope;
  p.constant_tension = 1500;
  return p;
}
const Bar::Parameters kWinch = make_winch();

void place_any(TestTile<2>& tile) {
  std::mt19937_64 random(5);
  for (double& x : tile.x) x = uniform(random, -1, 1);
}

TEST(RopeAtConstantTension, MatchesItsOracle) {
  TestTile<2> tile(kViscousWater);
  place_any(tile);
  const std::vector<Bar::Data> data(kLanes, Bar::Data{kLength});
  expect_kernel_matches_oracle<Bar, Bar::Tension>(kWinch, data, kViscousWater, tile, false);
}

TEST(RopeAtConstantTension, HasNoSpringAndReportsItsTension) {
  TestTile<2> tile(kViscousWater);
  place_any(tile);
  const std::vector<Bar::Data> data(kLanes, Bar::Data{kLength});
  const auto family = make_family<Bar>(kWinch, data);
  ASSERT_EQ(Bar::Elastic::tile(family, tile.t), Status::ok);
  for (const double f : tile.force) EXPECT_EQ(f, 0);
  EXPECT_EQ(Bar::stretch(kWinch, data[0], {}).T, 1500);
}

}  // namespace
