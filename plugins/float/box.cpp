// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/float/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft::floats {

void Box::check(const Parameters&, const Data& d) {
  if (!(d.pieces >= 0)) throw std::invalid_argument("the number of boxes at a node must not be negative");
}

Box::Depth Box::immersed(const Parameters& p, double above) {  // (1)
  const double below = (p.hangs ? p.height : 0) - above;
  if (below <= 0) return {0, 0};
  return below < p.height ? Depth{below, -1} : Depth{p.height, 0};
}

Status Box::Buoyancy::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const double lift = d.pieces * s.water.density * s.water.gravity * p.length_x * p.length_y;
  const double above = s.x[0].z - s.surface[0];
  const auto [depth, slope] = immersed(p, above);
  const double below = (p.hangs ? p.height : 0) - above;
  out.energy = lift * depth * (std::max(below, 0.0) - 0.5 * depth);  // (2)
  out.force[0].z = -lift * depth;
  out.tangent[2][2] = -s.cu * lift * slope;
  return Status::ok;
}

Status Box::Weight::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const double weight = d.pieces * p.mass * s.water.gravity;
  out.energy = weight * s.x[0].z;  // (3)
  out.force[0].z = weight;
  return Status::ok;
}

Status Box::Drag::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const auto [depth, slope] = immersed(p, s.x[0].z - s.surface[0]);
  const Vec3<double> W = s.current[0] - s.v[0];
  const double speed = norm(W), half = 0.5 * d.pieces * s.water.density;
  const std::array<double, 3> k{half * p.drag_x * p.length_y, half * p.drag_y * p.length_x,
                                p.height > 0 ? half * p.drag_z * p.length_x * p.length_y / p.height : 0};
  for (int r = 0; r < 3; ++r) {
    const double per_metre = k[static_cast<std::size_t>(r)] * speed * W[r];
    out.force[0][r] = -per_metre * depth;  // (4)
    if (!s.wants_tangent || speed == 0) continue;
    out.tangent[r][2] -= s.cu * per_metre * slope;
    for (int c = 0; c < 3; ++c) {
      const double D = k[static_cast<std::size_t>(r)] * depth * ((r == c ? speed : 0) + W[r] * W[c] / speed);
      out.tangent[r][c] += s.cv * D;
      out.tangent[r][2] -= s.cu * D * s.current_dz[0][c];
    }
  }
  return Status::ok;
}

Status Box::Inertia::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const double mass = d.pieces * (p.mass + p.added_mass);
  out.force[0] = mass * s.a[0];  // (5)
  for (int axis = 0; axis < 3; ++axis) out.tangent[axis][axis] = s.ca * mass;
  return Status::ok;
}

Status Box::Waves::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const Depth immersion = immersed(p, s.x[0].z - s.surface[0]);
  const double per_metre = d.pieces * s.water.density * p.length_x * p.length_y;
  out.force[0] = (-d.pieces * p.added_mass) * s.water_acceleration[0];  // (6)
  for (int axis = 0; axis < 2; ++axis)
    out.force[0][axis] -= per_metre * immersion.d * s.water_acceleration[0][axis];
  for (int axis = 0; axis < 2; ++axis)
    out.tangent[axis][2] = -s.cu * per_metre * immersion.slope * s.water_acceleration[0][axis];
  return Status::ok;
}

}  // namespace netloft::floats
