// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/rope/bar.hpp"

namespace netloft::rope {

void Bar::check(const Parameters&, const Data& d) {
  if (!(d.rest_length > 0)) throw std::invalid_argument("a bar of rest length zero has no stiffness");
}

void Bar::pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane) {
  lanes.l0[lane] = d.rest_length;
  lanes.EA[lane] = p.EA;
  lanes.EA_compression[lane] = p.EA_compression;
  lanes.volume[lane] = std::numbers::pi / 4 * p.diameter * p.diameter * d.rest_length;
  lanes.density[lane] = p.density;
}

axial::Bar Bar::stretch(const Parameters& p, const Data& d, const State<2>& s) {
  const Vec3<double> w = s.x[1] - s.x[0];
  return axial::stretch(w.x, w.y, w.z, d.rest_length, p.EA, p.EA_compression);
}

namespace {

/// Adds ±A to the four blocks of a bar's packed tangent: [ A −A; −A A ].
inline void add_blocks(const axial::Block& A, double* __restrict tangent, std::size_t lane) {
  std::size_t entry = 0;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c <= r; ++c, ++entry) {
      const double a = A.v[axial::kPlace[r % 3][c % 3]];
      tangent[entry * kLanes + lane] += r / 3 == c / 3 ? a : -a;
    }
}

}  // namespace

Status Bar::Elastic::tile(const Family<Bar>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  const double* __restrict x = t.x;
  double* __restrict energy = t.energy;
  double* __restrict force = t.force;
  double* __restrict tangent = t.tangent;
  const bool convex = t.want & NETLOFT_WANT_CONVEX, metric = t.want & NETLOFT_WANT_METRIC;
  const double cu = t.cu;
  const auto at = [](int dof, std::size_t lane) { return static_cast<std::size_t>(dof) * kLanes + lane; };

  if (metric) {
    for (std::size_t i = 0; i < t.count; ++i) {
      const double m = p.EA[i] / p.l0[i];  // axial (6)
      add_blocks({{m, 0, m, 0, 0, m}}, tangent, i);
    }
    return Status::ok;
  }
  for (std::size_t i = 0; i < t.count; ++i) {
    const double wx = x[at(3, i)] - x[at(0, i)], wy = x[at(4, i)] - x[at(1, i)],
                 wz = x[at(5, i)] - x[at(2, i)];
    const auto b = axial::stretch(wx, wy, wz, p.l0[i], p.EA[i], p.EA_compression[i]);
    if (energy) energy[i] += b.energy;
    if (force) {
      const double f = b.T * b.inverse;  // (1)
      force[at(0, i)] -= f * wx, force[at(1, i)] -= f * wy, force[at(2, i)] -= f * wz;
      force[at(3, i)] += f * wx, force[at(4, i)] += f * wy, force[at(5, i)] += f * wz;
    }
    if (tangent) add_blocks(axial::stiffness(b, wx, wy, wz, cu, convex), tangent, i);
  }
  return Status::ok;
}

Status Bar::Weight::tile(const Family<Bar>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  for (std::size_t i = 0; i < t.count; ++i) {
    const double half = 0.5 * p.volume[i] * (p.density[i] - t.water_density) * t.gravity;  // (2)
    if (t.energy) t.energy[i] += half * (t.x[2 * kLanes + i] + t.x[5 * kLanes + i]);
    if (t.force) t.force[2 * kLanes + i] += half, t.force[5 * kLanes + i] += half;
  }
  return Status::ok;
}

}  // namespace netloft::rope
