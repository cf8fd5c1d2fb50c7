// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/plugin/node.hpp"

namespace netloft::femnet {

namespace {
constexpr std::size_t at(int row, std::size_t lane) { return static_cast<std::size_t>(row) * kLanes + lane; }
/// Index of (axis, axis) in a packed lower triangle.
constexpr int diagonal(int axis) { return axis * (axis + 1) / 2 + axis; }
}  // namespace

Status Node::Load::tile(const Family<Node>& family, netloft_tile& t) {
  for (std::size_t i = 0; i < t.count; ++i) {
    const Data& d = family.data(t.first + i);
    const double pull[3] = {d.force[0], d.force[1], d.force[2] - d.mass * t.gravity};
    for (int axis = 0; axis < 3; ++axis) {  // (1)
      if (t.energy) t.energy[i] -= d.share * pull[axis] * t.x[at(axis, i)];
      if (t.force) t.force[at(axis, i)] -= d.share * pull[axis];
    }
  }
  return Status::ok;
}

Status Node::Buoyancy::tile(const Family<Node>& family, netloft_tile& t) {
  for (std::size_t i = 0; i < t.count; ++i) {
    const Data& d = family.data(t.first + i);
    const double H = std::abs(d.box[2]), immersed = (d.box[2] > 0 ? 0.5 * H : 0) - t.x[at(2, i)];
    const double lift = d.share * t.water_density * t.gravity * std::abs(d.box[0] * d.box[1]);
    if (!(immersed > 0)) continue;
    const bool whole = immersed >= H;
    if (t.energy)
      t.energy[i] += lift * (whole ? H * (immersed - 0.5 * H) : 0.5 * immersed * immersed);  // (2)
    if (t.force) t.force[at(2, i)] -= lift * (whole ? H : immersed);
    if (t.tangent && !whole) t.tangent[at(diagonal(2), i)] += t.cu * lift;
  }
  return Status::ok;
}

Status Node::Limit::tile(const Family<Node>& family, netloft_tile& t) {
  for (std::size_t i = 0; i < t.count; ++i) {
    const Data& d = family.data(t.first + i);
    const double k = d.share * family.parameters(t.first + i).stiffness;
    for (int axis = 0; axis < 3; ++axis) {
      const bool limited = d.sense[static_cast<std::size_t>(axis)] != 0;
      if (t.want & NETLOFT_WANT_METRIC) {
        if (limited) t.tangent[at(diagonal(axis), i)] += k;
        continue;
      }
      const double p = violation(d, axis, t.x[at(axis, i)]);
      if (t.energy) t.energy[i] += 0.5 * k * p * p;  // (3)
      if (t.force) t.force[at(axis, i)] -= k * p;
      if (t.tangent && p != 0) t.tangent[at(diagonal(axis), i)] += t.cu * k;
    }
  }
  return Status::ok;
}

Status Node::Friction::tile(const Family<Node>& family, netloft_tile& t) {
  if (!t.current) return Status::ok;
  for (std::size_t i = 0; i < t.count; ++i) {
    const Data& d = family.data(t.first + i);
    const double press = std::max(0.0, violation(d, 2, t.x[at(2, i)]));
    if (!(press > 0)) continue;
    const Vec3<double> flow{t.current[at(0, i)], t.current[at(1, i)], t.current[at(2, i)]};
    const double speed = norm(flow);
    if (!(speed > 0)) continue;
    const Parameters& p = family.parameters(t.first + i);
    const Vec3<double> drag = (d.share * p.friction * p.stiffness / speed) * flow;
    for (int axis = 0; axis < 3; ++axis) {
      if (t.force) t.force[at(axis, i)] -= press * drag[axis];  // (4)
      if (t.tangent) t.tangent[at(3 * axis + 2, i)] += t.cu * drag[axis];
    }
  }
  return Status::ok;
}

}  // namespace netloft::femnet
