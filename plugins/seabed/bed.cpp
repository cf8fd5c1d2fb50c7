// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/seabed/bed.hpp"

namespace netloft::seabed {

Status OnBed::Contact::evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out) {
  const Bed& b = s.bed[0];
  if (!b.is_there) return Status::ok;
  const Plane::Depth depth = Plane::press(b.height + p.radius - s.x[0].z, p.softness);
  const double K = stiffness_of(p, d), up[3] = {-b.slope_x, -b.slope_y, 1};
  const double bent[3][3] = {{b.xx, b.xy, 0}, {b.xy, b.yy, 0}, {0, 0, 0}};
  out.energy = K * depth.f;  // (2)
  for (int r = 0; r < 3; ++r) {
    out.force[0][r] = -K * depth.f1 * up[r];
    for (int c = 0; c < 3; ++c)
      out.tangent[r][c] = s.cu * K * (depth.f2 * up[r] * up[c] + depth.f1 * bent[r][c]);
  }
  return Status::ok;
}

}  // namespace netloft::seabed
