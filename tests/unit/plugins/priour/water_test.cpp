// SPDX-License-Identifier: BSD-3-Clause
//
// Forces of water and motion on netting compared with their formulas in dual numbers, and with values by
// hand.
#include <netloft/law.hpp>

#include "plugins/priour/drag.hpp"
#include "plugins/priour/netting_motion.hpp"
#include "plugins/priour/slowed.hpp"

#include "tests/unit/plugins/kernel_oracle.hpp"

#include <numbers>

namespace {

using namespace netloft;
using namespace netloft::priour;

constexpr double kDensity = 1025;
Triangle::Parameters twine() {
  Triangle::Parameters p{1e4, 1, 0.004, 1140};
  p.damping = 30, p.added_mass = 1.2;
  return p;
}

/// Laws that use all their inputs, of twines and of screens.
template <netloft_law_kind Kind>
struct SomeLaw {
  static constexpr auto kind = Kind;
  struct Parameters {};
  template <class T>
  static Vec3<T> force(const Parameters&, const Flow<T>& f) {
    const double h = Kind == NETLOFT_TWINE_LAW ? f.diameter : 1;
    const T speed = norm(f.flow);
    return (0.5 * f.density * h * (1.0 + f.solidity * f.solidity)) *
           (1.2 * speed * f.flow + 0.3 * dot(f.flow, f.direction) * speed * f.direction);
  }
};
using TwineLaw = SomeLaw<NETLOFT_TWINE_LAW>;
using ScreenLaw = SomeLaw<NETLOFT_SCREEN_LAW>;

/// 64 triangles that move in a current with shear.
struct Moving {
  Moving() {
    std::mt19937_64 random(4);
    t.size = sizeof t, t.want = NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT, t.count = kLanes;
    t.cu = 0.7, t.cv = 1.3, t.ca = 0.9, t.water_density = kDensity;
    t.x = x, t.v = v, t.a = a, t.current = current, t.current_dz = dz, t.force = force, t.tangent = tangent;
    for (std::size_t i = 0; i < 9 * kLanes; ++i) {
      x[i] = uniform(random, -0.5, 0.5), v[i] = uniform(random, -1, 1), a[i] = uniform(random, -1, 1);
      current[i] = uniform(random, -1, 1), dz[i] = uniform(random, -0.3, 0.3);
    }
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const double s = uniform(random, 2, 6), skew = uniform(random, -0.5, 0.5);
      data.push_back({{0, s, skew}, {0, skew, s}, 0.1});
      if (lane % 2)
        std::swap(data.back().u[1], data.back().u[2]), std::swap(data.back().v[1], data.back().v[2]);
    }
  }
  double x[9 * kLanes], v[9 * kLanes], a[9 * kLanes], current[9 * kLanes], dz[9 * kLanes];
  double force[9 * kLanes] = {}, tangent[81 * kLanes] = {};
  std::vector<Triangle::Data> data;
  netloft_tile t{};
};

/// A tile's state as dual numbers of x (0 … 8), v (9 … 17) and a (18 … 26).
using D = Dual<27, 1>;
struct Corners {
  Corners(const Moving& m, std::size_t lane) {
    for (int d = 0; d < 9; ++d) {
      const auto p = static_cast<std::size_t>(d / 3);
      x[p][d % 3] = D::variable(m.x[at(d, lane)], d);
      v[p][d % 3] = D::variable(m.v[at(d, lane)], 9 + d);
      a[p][d % 3] = D::variable(m.a[at(d, lane)], 18 + d);
    }
    for (int d = 0; d < 9; ++d) {
      const auto p = static_cast<std::size_t>(d / 3);
      c[p][d % 3] = m.current[at(d, lane)] + m.dz[at(d, lane)] * (x[p].z - x[p].z.value);
    }
    const auto h = Triangle::shape(m.data[lane]);
    bars = h.bars;
    for (int p = 0; p < 3; ++p) shape[0][p] = h.a[p], shape[1][p] = h.b[p];
  }
  Vec3<D> along(int direction, const Points<D, 3>& field) const {
    const double(&k)[3] = shape[direction];
    return k[0] * field[0] + k[1] * field[1] + k[2] * field[2];
  }
  Vec3<D> unit(int direction) const {
    const Vec3<D> w = along(direction, x);
    return (D(1) / norm(w)) * w;
  }
  Points<D, 3> x, v, a, c;
  double bars, shape[2][3];
};

using Residual = Points<D, 3>;

/// Fraction of the velocity of the water that is left at a triangle.
D left_at(const Corners& k, const Triangle::Parameters& p) {
  const Vec3<D> middle = D(1.0 / 3) * (k.x[0] + k.x[1] + k.x[2]);
  const D d =
      p.slowed_front - std::cos(p.slowed_direction) * middle.x - std::sin(p.slowed_direction) * middle.y;
  const D near = 1.0 + (1 / (p.slowed_radius * p.slowed_radius)) * d * d;
  return d > D(0) ? 1.0 - p.slowed_by / (near * sqrt(near)) : D(1 - p.slowed_by);
}

template <class Law>
Residual drag_in(const D& left, const Corners& k, const Triangle::Data& d, const Triangle::Parameters& p) {
  Flow<D> f;
  f.flow = D(1.0 / 3) * (left * (k.c[0] + k.c[1] + k.c[2]) - k.v[0] - k.v[1] - k.v[2]);
  f.diameter = p.diameter, f.density = kDensity;
  Vec3<D> F;
  if (Law::kind == NETLOFT_TWINE_LAW) {
    for (const int direction : {0, 1}) {
      f.direction = k.unit(direction);
      F += D(k.bars * d.bar_length) * Law::force({}, f);
    }
  } else {
    const Vec3<D> N = cross(k.x[1] - k.x[0], k.x[2] - k.x[0]);
    const D area = 0.5 * norm(N);
    f.direction = (D(1) / norm(N)) * N;
    f.solidity = 2 * k.bars * p.diameter * d.bar_length / area;
    F = area * Law::force({}, f);
  }
  const Vec3<D> third = D(-1.0 / 3) * F;
  return {third, third, third};
}

template <class Law>
Residual drag(const Corners& k, const Triangle::Data& d, const Triangle::Parameters& p) {
  return drag_in<Law>(D(1), k, d, p);
}

template <class Law>
Residual lost_drag(const Corners& k, const Triangle::Data& d, const Triangle::Parameters& p) {
  Residual lost = drag_in<Law>(left_at(k, p), k, d, p);
  const Residual whole = drag_in<Law>(D(1), k, d, p);
  for (std::size_t q = 0; q < 3; ++q) lost[q] -= whole[q];
  return lost;
}

Residual damping(const Corners& k, const Triangle::Data& d, const Triangle::Parameters& p) {
  Residual r;
  for (const int direction : {0, 1}) {
    const Vec3<D> t = k.unit(direction), T = (p.damping / d.bar_length * dot(t, k.along(direction, k.v))) * t;
    for (std::size_t q = 0; q < 3; ++q) r[q] += D(k.bars * k.shape[direction][q]) * T;
  }
  return r;
}

/// The damping (1), (2) of loss.hpp for both directions of twines.
Residual loss(const Corners& k, const Triangle::Data& d, const Triangle::Parameters& p) {
  Residual r;
  for (const int direction : {0, 1}) {
    const Vec3<D> t = k.unit(direction);
    const D y = (dot(t, k.along(direction, k.x)) * (1 / d.bar_length) - D(1)) * D(1e4);
    const D share = y < D(0) ? D(0) : y > D(1) ? D(1) : y * y * (D(3) - D(2) * y);
    const double c = p.EA * p.loss_factor / (2 * std::numbers::pi * p.loss_frequency) / d.bar_length;
    const Vec3<D> T = (c * share * dot(t, k.along(direction, k.v))) * t;
    for (std::size_t q = 0; q < 3; ++q) r[q] += D(k.bars * k.shape[direction][q]) * T;
  }
  return r;
}

Residual inertia(const Corners& k, const Triangle::Data& d, const Triangle::Parameters& p) {
  Residual r;
  const double third = k.bars * std::numbers::pi / 4 * p.diameter * p.diameter * d.bar_length / 3;
  const double added = third * p.added_mass * kDensity;
  for (const int direction : {0, 1}) {
    const Vec3<D> t = k.unit(direction);
    for (std::size_t q = 0; q < 3; ++q)
      r[q] += D(third * p.density + added) * k.a[q] - (added * dot(t, k.a[q])) * t;
  }
  return r;
}

template <class Term, class Oracle>
void expect_matches(const netloft_bound_law& law, Oracle&& oracle, const Triangle::Parameters& p = twine()) {
  Moving m;
  auto family = make_family<Triangle>(p, m.data);
  family.laws_ = {law};
  ASSERT_EQ(Term::tile(family, m.t), Status::ok);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const Residual r = oracle(Corners(m, lane), m.data[lane], p);
    std::array<double, 9> force;
    std::array<double, 81> tangent;
    for (std::size_t row = 0; row < 9; ++row) {
      const D& value = r[row / 3][static_cast<int>(row % 3)];
      force[row] = value.value;
      for (std::size_t c = 0; c < 9; ++c)
        tangent[9 * row + c] =
            m.t.cu * value.gradient[c] + m.t.cv * value.gradient[9 + c] + m.t.ca * value.gradient[18 + c];
    }
    EXPECT_LT(relative_error(m.force, force, lane), 1e-13) << "force of lane " << lane;
    EXPECT_LT(relative_error(m.tangent, tangent, lane), 1e-12) << "tangent of lane " << lane;
  }
}

const TwineLaw::Parameters kNone;
const ScreenLaw::Parameters kNoneEither;
const netloft_bound_law kTwines{NETLOFT_TWINE_LAW, 0, &kNone, &detail::evaluate_law<TwineLaw>};
const netloft_bound_law kScreens{NETLOFT_SCREEN_LAW, 0, &kNoneEither, &detail::evaluate_law<ScreenLaw>};

TEST(NettingDrag, MatchesItsOracleTwineByTwine) { expect_matches<Drag>(kTwines, drag<TwineLaw>); }

TEST(NettingDrag, MatchesItsOracleAsAScreen) { expect_matches<Drag>(kScreens, drag<ScreenLaw>); }

/// Netting in slowed water; some triangles are ahead of the front of the catch, the others behind it.
Triangle::Parameters behind_slowed_water() {
  auto p = twine();
  p.slowed_by = 0.7, p.slowed_front = 0.1, p.slowed_radius = 0.3, p.slowed_direction = 0.4;
  return p;
}

TEST(SlowedDrag, MatchesItsOracle) {
  expect_matches<SlowedDrag>(kTwines, lost_drag<TwineLaw>, behind_slowed_water());
  expect_matches<SlowedDrag>(kScreens, lost_drag<ScreenLaw>, behind_slowed_water());
}

TEST(NettingDamping, MatchesItsOracle) { expect_matches<Damping>(kTwines, damping); }

TEST(NettingLoss, MatchesItsOracle) {
  auto p = twine();
  p.loss_factor = 0.3, p.loss_frequency = 7;
  expect_matches<Loss>(kTwines, loss, p);
}

TEST(NettingInertia, MatchesItsOracle) { expect_matches<Inertia>(kTwines, inertia); }

/// Netting of 10 x 10 bars normal to a flow of 2 m/s.
struct AcrossTheFlow : Moving {
  AcrossTheFlow() {
    t.count = 1, t.want = NETLOFT_WANT_FORCE, t.tangent = nullptr, t.v = nullptr, t.current_dz = nullptr;
    data.assign(1, {{0, 10, 0}, {0, 0, 10}, 0.1});
    for (int d = 0; d < 9; ++d) x[at(d, 0)] = 0, current[at(d, 0)] = d % 3 == 0 ? 2 : 0;
    x[at(4, 0)] = 0.9, x[at(8, 0)] = 0.9;
  }
  double total(const netloft_bound_law& law, const Triangle::Parameters& p = twine()) {
    auto family = make_family<Triangle>(p, data);
    family.laws_ = {law};
    std::fill(std::begin(force), std::end(force), 0.0);
    EXPECT_EQ(Drag::tile(family, t), Status::ok);
    EXPECT_EQ(SlowedDrag::tile(family, t), Status::ok);
    return -force[at(0, 0)] - force[at(3, 0)] - force[at(6, 0)];
  }
};

TEST(NettingDrag, TakesTheUnstretchedTwinesOfBothDirections) {  // 50 bars each
  EXPECT_NEAR(AcrossTheFlow().total(kTwines), 100 * 0.1 * 0.5 * kDensity * 0.004 * 1.2 * 4, 1e-10);
}

TEST(NettingDrag, TakesTheAreaAndSolidityThatAScreenHas) {
  const double area = 0.5 * 0.9 * 0.9, solidity = 100 * 0.1 * 0.004 / area;
  EXPECT_NEAR(AcrossTheFlow().total(kScreens),
              area * 0.5 * kDensity * (1 + solidity * solidity) * (1.2 + 0.3) * 4, 1e-9);
}

TEST(NettingDrag, IsReportedAsOneNumberAndIsNothingWithoutALaw) {
  AcrossTheFlow m;
  const auto p = twine();
  auto family = make_family<Triangle>(p, m.data);
  double values[kLanes] = {-1};
  family.laws_ = {kTwines};
  Drag::output(family, m.t, values);
  EXPECT_NEAR(values[0], m.total(kTwines), 1e-10);
  family.laws_ = {netloft_bound_law{}};
  Drag::output(family, m.t, values);
  EXPECT_EQ(values[0], 0);
}

TEST(SlowedDrag, LeavesTheSquareOfWhatIsLeftOfTheVelocity) {
  AcrossTheFlow net;
  const double whole = net.total(kTwines);
  auto p = twine();
  p.slowed_by = 0.4, p.slowed_front = -1, p.slowed_radius = 2;
  EXPECT_NEAR(net.total(kTwines, p) / whole, 0.36, 1e-12) << "behind the front";
  p.slowed_front = 2;  // a radius ahead
  EXPECT_NEAR(net.total(kTwines, p) / whole, std::pow(1 - 0.4 / std::sqrt(8), 2), 1e-12);
  p.slowed_front = 200;
  EXPECT_NEAR(net.total(kTwines, p) / whole, 1, 1e-6) << "far ahead";
}

}  // namespace
