// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/seabed/bed.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::seabed {

namespace {

using Slope = Dual<3, 1>;

constexpr std::size_t at(std::size_t row, std::size_t lane) { return row * kLanes + lane; }

Vec3<double> read(const double* field, std::size_t lane) {
  return {field[at(0, lane)], field[at(1, lane)], field[at(2, lane)]};
}

Bed bed_under(const netloft_tile& t, std::size_t lane) {
  const double* bed = bed_of(t);
  if (!bed) return {};
  const auto b = [&](std::size_t k) { return bed[at(k, lane)]; };
  return {true, t.x[at(0, lane)], t.x[at(1, lane)], b(0), b(1), b(2), b(3), b(4), b(5)};
}

/// Reads position and velocity of one node as dual numbers. Their derivatives are the factors cu and cv of
/// the tile, so that the derivatives of a residual computed from them are a row of the tangent.
MovingNodes<Slope, 1> motion_of(const netloft_tile& t, std::size_t lane) {
  MovingNodes<Slope, 1> m;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Slope &x = m.x[0][static_cast<int>(axis)], &v = m.v[0][static_cast<int>(axis)];
    x = Slope(t.x[at(axis, lane)]);
    v = Slope(t.v ? t.v[at(axis, lane)] : 0);
    x.gradient[axis] = t.cu;
    v.gradient[axis] = t.cv;
  }
  m.bed[0] = bed_under(t, lane);
  if (const double* ground = ground_of(t)) m.ground = {ground[0], ground[1], ground[2]};
  return m;
}

void add(const Vec3<Slope>& residual, std::size_t lane, netloft_tile& t) {
  for (std::size_t r = 0; r < 3; ++r) {
    const Slope& entry = residual[static_cast<int>(r)];
    if (t.force) t.force[at(r, lane)] += entry.value;
    for (std::size_t c = 0; c < 3 && t.tangent; ++c) t.tangent[at(3 * r + c, lane)] += entry.gradient[c];
  }
}

void remember(const Vec3<double>& anchor, bool has_past, std::size_t lane, netloft_tile& t) {
  double* state_new = new_state_of(t);
  if (!state_new) return;
  for (std::size_t axis = 0; axis < 3; ++axis) state_new[at(axis, lane)] = anchor[static_cast<int>(axis)];
  state_new[at(3, lane)] = has_past ? 1 : 0;
}

/// Adds the friction of a bed at rest, on which the node sticks or slides: plane.hpp (4) to (7).
void hold(const OnBed::Parameters& p, const OnBed::Data& d, const OnBed::Whole& whole, std::size_t lane,
          netloft_tile& t) {
  const Vec3<double> x = read(t.x, lane);
  const double* state = state_of(t);
  const bool has_past = state && state[at(3, lane)] != 0;
  const Vec3<double> anchor = has_past ? read(state, lane) : x;
  const auto grip = OnBed::grip(p, d, whole, motion_of(t, lane), anchor);
  const double way = norm(Vec3<double>{grip.d.x.value, grip.d.y.value, grip.d.z.value});
  const double rounding = Plane::kRounding * std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  const double spring = grip.spring.value, limit = grip.limit.value;
  if (!has_past || !(limit > 0)) return remember(x, true, lane, t);
  if (spring * (way - rounding) <= limit) {
    add(grip.spring * grip.d, lane, t);
    return remember(anchor, true, lane, t);
  }
  const Vec3<Slope> residual = (grip.limit / norm(grip.d)) * grip.d;
  add(residual, lane, t);
  const double back = 1 / spring;
  remember(x - back * Vec3<double>{residual.x.value, residual.y.value, residual.z.value}, true, lane, t);
}

}  // namespace

void OnBed::gather(const Parameters& p, const Data&, Whole& whole) {
  if (whole.stiffness.empty() && p.bottom.rows) {
    whole.stiffness = Surface(p.bottom, 2);
    whole.friction = Surface(p.bottom, 3);
  }
}

Status OnBed::Contact::evaluate(const Parameters& p, const Data& d, const Whole& whole, const State<1>& s,
                                Local<1>& out) {
  const Bed& b = s.bed[0];
  if (!b.is_there) return Status::ok;
  using T = Dual<2>;
  const T m = factor(whole.stiffness, Vec3<T>{T::variable(s.x[0].x, 0), T::variable(s.x[0].y, 1), T(0)});
  const Plane::Depth depth = Plane::press(-gap(p, s), p.softness);
  const double K = stiffness_of(p, d), up[3] = {-b.slope_x, -b.slope_y, 1};
  const double bent[3][3] = {{b.xx, b.xy, 0}, {b.xy, b.yy, 0}, {0, 0, 0}};
  const double grows[3] = {m.gradient[0], m.gradient[1], 0};
  const double curved[3][3] = {{m.hessian[0], m.hessian[1], 0}, {m.hessian[1], m.hessian[2], 0}, {0, 0, 0}};
  out.energy = K * m.value * depth.f;  // (2)
  for (int r = 0; r < 3; ++r) {
    out.force[0][r] = K * (depth.f * grows[r] - m.value * depth.f1 * up[r]);
    for (int c = 0; c < 3; ++c)
      out.tangent[r][c] = s.cu * K *
                          (m.value * (depth.f2 * up[r] * up[c] + depth.f1 * bent[r][c]) -
                           depth.f1 * (up[r] * grows[c] + grows[r] * up[c]) + depth.f * curved[r][c]);
  }
  return Status::ok;
}

Status OnBed::Friction::tile(const Family<OnBed>& family, netloft_tile& t) {
  for (std::size_t lane = 0; lane < t.count; ++lane) {
    const std::size_t element = t.first + lane;
    const Parameters& p = family.parameters(element);
    const Data& d = family.data(element);
    if (!ground_of(t)) {
      hold(p, d, family.whole(element), lane, t);
      continue;
    }
    add(-force(p, d, family.whole(element), motion_of(t, lane))[0], lane, t);
    remember(read(t.x, lane), false, lane, t);
  }
  return Status::ok;
}

}  // namespace netloft::seabed
