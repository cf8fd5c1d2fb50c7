// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/rope/bar.hpp"

#include "plugins/rope/chords.hpp"

#include <limits>

namespace netloft::rope {

void Bar::check(const Parameters&, const Data& d) {
  if (!(d.rest_length > 0)) throw std::invalid_argument("a bar of rest length zero has no stiffness");
}

void Bar::pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane) {
  lanes.l0[lane] = d.rest_length;
  const bool springs = p.constant_tension == 0;
  lanes.EA[lane] = springs ? p.EA : 0;
  lanes.EA_compression[lane] = springs ? p.EA_compression : 0;
  lanes.volume[lane] = std::numbers::pi / 4 * p.diameter * p.diameter * d.rest_length;
  lanes.density[lane] = p.density;
  lanes.diameter[lane] = p.diameter;
  lanes.constant_tension[lane] = p.constant_tension;
  lanes.damping[lane] = p.damping;
  lanes.added_mass[lane] = p.added_mass;
}

axial::Bar Bar::stretch(const Parameters& p, const Data& d, const State<2>& s) {
  const Vec3<double> w = s.x[1] - s.x[0];
  auto bar = axial::stretch(w.x, w.y, w.z, d.rest_length, p.EA, p.EA_compression);
  if (p.constant_tension > 0) bar.T = p.constant_tension;
  return bar;
}

namespace {

/// Adds ±A to the four blocks of a bar's packed tangent: [ A −A; −A A ]. `A` has six numbers per lane.
inline void add_blocks(const double (&A)[6][kLanes], std::uint32_t count, double* __restrict tangent) {
  int entry = 0;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c <= r; ++c, ++entry) {
      const double* a = A[axial::kPlace[r % 3][c % 3]];
      const double sign = r / 3 == c / 3 ? 1 : -1;
      for (std::size_t i = 0; i < count; ++i) tangent[at(entry, i)] += sign * a[i];
    }
}

}  // namespace

Status Bar::Elastic::tile(const Family<Bar>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  const double* __restrict x = t.x;
  double A[6][kLanes];
  if (t.want & NETLOFT_WANT_METRIC) {
    for (std::size_t i = 0; i < t.count; ++i) {
      A[0][i] = A[2][i] = A[5][i] = std::max(p.EA[i], p.EA_compression[i]) / p.l0[i];  // axial (6)
      A[1][i] = A[3][i] = A[4][i] = 0;
    }
    add_blocks(A, t.count, t.tangent);
    return Status::ok;
  }
  // Plain loops over lanes, one purpose each: that is what compilers turn into vector code.
  double wx[kLanes], wy[kLanes], wz[kLanes], inverse[kLanes], T[kLanes], k[kLanes], energy[kLanes];
  for (std::size_t i = 0; i < t.count; ++i) {
    wx[i] = x[at(3, i)] - x[at(0, i)], wy[i] = x[at(4, i)] - x[at(1, i)], wz[i] = x[at(5, i)] - x[at(2, i)];
    const auto b = axial::stretch(wx[i], wy[i], wz[i], p.l0[i], p.EA[i], p.EA_compression[i]);
    inverse[i] = b.inverse, T[i] = b.T, k[i] = b.k, energy[i] = b.energy;
  }
  if (t.energy)
    for (std::size_t i = 0; i < t.count; ++i) t.energy[i] += energy[i];
  if (double* __restrict force = t.force)
    for (std::size_t i = 0; i < t.count; ++i) {
      const double f = T[i] * inverse[i];  // (1)
      force[at(0, i)] -= f * wx[i], force[at(1, i)] -= f * wy[i], force[at(2, i)] -= f * wz[i];
      force[at(3, i)] += f * wx[i], force[at(4, i)] += f * wy[i], force[at(5, i)] += f * wz[i];
    }
  if (t.tangent) {
    const double lowest = t.want & NETLOFT_WANT_CONVEX ? 0.0 : -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < t.count; ++i) {
      const auto a = axial::stiffness({0, inverse[i], T[i], k[i], 0}, wx[i], wy[i], wz[i], t.cu, lowest);
      for (int m = 0; m < 6; ++m) A[m][i] = a.v[m];
    }
    add_blocks(A, t.count, t.tangent);
  }
  return Status::ok;
}

Status Bar::Tension::tile(const Family<Bar>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  const Chords chord(t, p.l0);
  double A[6][kLanes];
  for (std::size_t i = 0; i < t.count; ++i) {
    const double T = p.constant_tension[i];
    if (t.energy) t.energy[i] += T * chord.l[i];
    if (t.force)
      for (int axis = 0; axis < 3; ++axis) {
        t.force[at(axis, i)] -= T * chord.t[axis][i];
        t.force[at(axis + 3, i)] += T * chord.t[axis][i];
      }
    const double g = t.cu * T * chord.inverse[i];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c <= r; ++c)
        A[axial::kPlace[r][c]][i] = g * ((r == c ? 1 : 0) - chord.t[r][i] * chord.t[c][i]);
  }
  if (t.tangent) add_blocks(A, t.count, t.tangent);  // positive semi-definite as it is
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
