// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/rope/bar.hpp"

namespace netloft::rope {

void Bar::check(const Parameters&, const Data& d) {
  if (!(d.rest_length > 0)) throw std::invalid_argument("a bar of rest length zero has no stiffness");
}

void Bar::pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane) {
  bars::pack(p, d.rest_length, 1, lanes, lane);
  lanes.constant_tension[lane] = p.constant_tension;
  if (p.constant_tension > 0) lanes.EA[lane] = lanes.EA_compression[lane] = 0;
}

axial::Bar Bar::stretch(const Parameters& p, const Data& d, const State<2>& s) {
  const Vec3<double> w = s.x[1] - s.x[0];
  auto bar = axial::stretch(w.x, w.y, w.z, d.rest_length, p.EA, p.EA_compression);
  if (p.constant_tension > 0) bar.T = p.constant_tension;
  return bar;
}

Status Bar::Tension::tile(const Family<Bar>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  const bars::Chords chord(t, p.l0);
  double A[6][kLanes];
  for (std::size_t i = 0; i < t.count; ++i) {
    const double T = p.constant_tension[i];
    if (t.energy) t.energy[i] += T * chord.l[i];
    if (t.force)
      for (int axis = 0; axis < 3; ++axis) {
        t.force[bars::at(axis, i)] -= T * chord.t[axis][i];
        t.force[bars::at(axis + 3, i)] += T * chord.t[axis][i];
      }
    const double g = t.cu * T * chord.inverse[i];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c <= r; ++c)
        A[axial::kPlace[r][c]][i] = g * ((r == c ? 1 : 0) - chord.t[r][i] * chord.t[c][i]);
  }
  if (t.tangent) bars::add_blocks(A, t.count, t.tangent);  // positive semi-definite as it is
  return Status::ok;
}

}  // namespace netloft::rope
