// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/plugin/node.hpp"

namespace netloft::femnet {

namespace {
constexpr std::size_t at(int row, std::size_t lane) { return static_cast<std::size_t>(row) * kLanes + lane; }
/// Place of (axis, axis) in a packed lower triangle.
constexpr int diagonal(int axis) { return axis * (axis + 1) / 2 + axis; }
}  // namespace

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

Status Node::Friction::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const double press = std::max(0.0, violation(d, 2, s.x[0].z)), speed = norm(s.current[0]);
  if (!(press > 0) || !(speed > 0)) return Status::ok;
  const double drag = d.share * p.friction * p.stiffness;
  const Vec3<double> along = (1 / speed) * s.current[0];
  out.force[0] = (-drag * press) * along;  // (4)
  for (int r = 0; r < 3; ++r) out.tangent[r][2] = s.cu * drag * along[r];
  return Status::ok;
}

}  // namespace netloft::femnet
