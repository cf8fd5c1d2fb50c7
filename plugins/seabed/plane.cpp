// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/seabed/plane.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::seabed {

namespace {
constexpr std::size_t at(int row, std::size_t lane) { return static_cast<std::size_t>(row) * kLanes + lane; }
}  // namespace

void Plane::check(const Parameters&, const Data& d) {
  if (!(d.length >= 0) || !(d.pieces >= 0))
    throw std::invalid_argument("the length and the number of pieces at a node must not be negative");
}

void Plane::pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane) {
  const double n_z = 1 / std::sqrt(1 + p.slope_x * p.slope_x + p.slope_y * p.slope_y);  // (1)
  lanes.n[0][lane] = -p.slope_x * n_z;
  lanes.n[1][lane] = -p.slope_y * n_z;
  lanes.n[2][lane] = n_z;
  lanes.offset[lane] = n_z * p.depth;
  const double metres = d.length > 0 ? d.length : d.pieces;
  lanes.K[lane] = p.stiffness * metres;
  lanes.shear[lane] = p.shear_stiffness * metres;
  lanes.softness[lane] = p.softness;
  lanes.friction[lane] = p.friction;
}

Plane::Depth Plane::press(double depth, double softness) {  // (2)
  if (depth <= 0) return {0, 0, 0};
  if (depth < softness)
    return {depth * depth * depth / (6 * softness), depth * depth / (2 * softness), depth / softness};
  const double beyond = depth - 0.5 * softness;
  return {0.5 * beyond * beyond + softness * softness / 24, beyond, 1};
}

namespace {

Plane::Depth press_node(const Plane::Lanes& p, const netloft_tile& t, std::size_t i) {
  const double h = p.n[0][i] * t.x[at(0, i)] + p.n[1][i] * t.x[at(1, i)] + p.n[2][i] * t.x[at(2, i)];
  return Plane::press(-(h + p.offset[i]), p.softness[i]);
}

/// Adds factor n nᵀ to the packed lower triangle.
void add_normal_block(const Plane::Lanes& p, double factor, std::size_t i, double* tangent) {
  int entry = 0;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c <= r; ++c) tangent[at(entry++, i)] += factor * p.n[r][i] * p.n[c][i];
}

}  // namespace

Plane::Slip Plane::slip(double speed, double creep) {  // (9)
  if (speed >= creep) return {1 / speed, -1 / (speed * speed * speed)};
  return {(2 - speed / creep) / creep, speed > 0 ? -1 / (creep * creep * speed) : 0};
}

double Plane::gap(const Parameters& p, const State<1>& s) {
  const double n_z = 1 / std::sqrt(1 + p.slope_x * p.slope_x + p.slope_y * p.slope_y);
  return n_z * (s.x[0].z + p.depth - p.slope_x * s.x[0].x - p.slope_y * s.x[0].y);
}

double Plane::normal_force(const Parameters& p, const Data& d, const State<1>& s) {
  return p.stiffness * (d.length > 0 ? d.length : d.pieces) * press(-gap(p, s), p.softness).f1;
}

Status Plane::Contact::tile(const Family<Plane>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  for (std::size_t i = 0; i < t.count; ++i) {
    if (t.want & NETLOFT_WANT_METRIC) {
      add_normal_block(p, p.K[i], i, t.tangent);  // f'' ≤ 1
      continue;
    }
    const Depth depth = press_node(p, t, i);
    if (t.energy) t.energy[i] += p.K[i] * depth.f;  // (3)
    if (t.force)
      for (int axis = 0; axis < 3; ++axis) t.force[at(axis, i)] -= p.K[i] * depth.f1 * p.n[axis][i];
    if (t.tangent) add_normal_block(p, t.cu * p.K[i] * depth.f2, i, t.tangent);
  }
  return Status::ok;
}

namespace {

/// The friction (4)–(7) of plane.hpp for one node on the bed. After sliding, (7) places the anchor such that
/// (5) equals (6) up to rounding. A node with such an anchor counts as sticking; otherwise rounding would
/// decide which nodes of a line at rest stick.
struct Hold {
  double n[3], unit[3];       // normal n, and direction d̂
  double way, limit, spring;  // distance |d|, largest force μ N, stiffness κ L
  double rounding;            // rounding error of |d| [m]
  double limit_slope;         // −∂(μ N)/∂h = μ K f''
  bool slides() const { return spring * (way - rounding) > limit; }
  double force() const { return std::min(limit, spring * way); }
};

Hold hold_node(const Plane::Lanes& p, const netloft_tile& t, std::size_t i) {
  Hold b{};
  const double* state = state_of(t);
  const bool has_past = state && state[at(3, i)] != 0;
  double w[3] = {0, 0, 0}, along = 0, square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    b.n[axis] = p.n[axis][i];
    if (has_past) w[axis] = t.x[at(axis, i)] - state[at(axis, i)];
    along += b.n[axis] * w[axis];
  }
  for (int axis = 0; axis < 3; ++axis) {
    w[axis] -= along * b.n[axis];  // (4)
    square += w[axis] * w[axis];
    b.rounding = std::max(b.rounding, Plane::kRounding * std::abs(t.x[at(axis, i)]));
  }
  const Plane::Depth depth = press_node(p, t, i);
  b.limit = p.friction[i] * p.K[i] * depth.f1;
  b.limit_slope = p.friction[i] * p.K[i] * depth.f2;
  b.way = std::sqrt(square);
  b.spring = has_past && b.limit > 0 ? p.shear[i] : 0;
  for (int axis = 0; axis < 3; ++axis) b.unit[axis] = b.way > 0 ? w[axis] / b.way : 0;
  return b;
}

void add_tangent(const Hold& b, double cu, std::size_t i, double* tangent) {
  // While the node sticks, the spring resists in all directions along the bed. While it slides, only the
  // rotation of d̂ and changes of the normal force N contribute.
  const double across = b.slides() ? b.limit / b.way : b.spring, along = b.slides() ? 0 : b.spring;
  const double press = b.slides() ? b.limit_slope : 0;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const double flat = (r == c ? 1 : 0) - b.n[r] * b.n[c], way = b.unit[r] * b.unit[c];
      tangent[at(3 * r + c, i)] += cu * (across * (flat - way) + along * way - press * b.unit[r] * b.n[c]);
    }
}

void note_anchor(const Hold& b, const netloft_tile& t, std::size_t i, double* state_new) {  // (7)
  for (int axis = 0; axis < 3; ++axis) {
    const double x = t.x[at(axis, i)];
    const double stays = b.spring > 0 && !b.slides() ? state_of(t)[at(axis, i)] : x;
    const double back = b.spring > 0 && b.slides() ? b.limit / b.spring * b.unit[axis] : 0;
    state_new[at(axis, i)] = b.limit > 0 ? stays - back : x;
  }
  state_new[at(3, i)] = 1;
}

/// The friction (8), (9) of plane.hpp for one node on a moving bed.
struct Drag {
  double n[3], w[3];   // normal, velocity over the bed
  Plane::Slip slip;    // slip at the speed |w|
  double limit;        // largest friction μ N
  double limit_slope;  // −∂(μ N)/∂h = μ K f''
};

Drag drag_node(const Plane::Lanes& p, const netloft_tile& t, std::size_t i) {
  Drag d{};
  const double* g = ground_of(t);
  double along = 0, square = 0, ground = 0;
  for (int axis = 0; axis < 3; ++axis) {
    d.n[axis] = p.n[axis][i];
    d.w[axis] = (t.v ? t.v[at(axis, i)] : 0) - g[axis];
    along += d.n[axis] * d.w[axis];
    ground += g[axis] * g[axis];
  }
  for (int axis = 0; axis < 3; ++axis) {
    d.w[axis] -= along * d.n[axis];
    square += d.w[axis] * d.w[axis];
  }
  d.slip = Plane::slip(std::sqrt(square), Plane::kCreep * std::sqrt(ground));
  const Plane::Depth depth = press_node(p, t, i);
  d.limit = p.friction[i] * p.K[i] * depth.f1;
  d.limit_slope = p.friction[i] * p.K[i] * depth.f2;
  return d;
}

void add_tangent(const Drag& d, double cu, double cv, std::size_t i, double* tangent) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const double flat = (r == c ? 1 : 0) - d.n[r] * d.n[c];
      tangent[at(3 * r + c, i)] += cv * d.limit * (d.slip.h * flat + d.slip.slope * d.w[r] * d.w[c]) -
                                   cu * d.limit_slope * d.slip.h * d.w[r] * d.n[c];
    }
}

void drag_tile(const Plane::Lanes& p, netloft_tile& t) {
  double* state_new = new_state_of(t);
  for (std::size_t i = 0; i < t.count; ++i) {
    const Drag d = drag_node(p, t, i);
    for (int axis = 0; axis < 3; ++axis) {
      if (t.force) t.force[at(axis, i)] += d.limit * d.slip.h * d.w[axis];  // (9)
      if (state_new) state_new[at(axis, i)] = t.x[at(axis, i)];
    }
    if (state_new) state_new[at(3, i)] = 0;  // there is no past step and therefore no anchor
    if (t.tangent) add_tangent(d, t.cu, t.cv, i, t.tangent);
  }
}

}  // namespace

Status Plane::Friction::tile(const Family<Plane>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  if (ground_of(t)) return drag_tile(p, t), Status::ok;
  double* state_new = new_state_of(t);
  for (std::size_t i = 0; i < t.count; ++i) {
    const Hold b = hold_node(p, t, i);
    if (t.force)
      for (int axis = 0; axis < 3; ++axis) t.force[at(axis, i)] += b.force() * b.unit[axis];  // (5), (6)
    if (t.tangent) add_tangent(b, t.cu, i, t.tangent);
    if (state_new) note_anchor(b, t, i, state_new);
  }
  return Status::ok;
}

}  // namespace netloft::seabed
