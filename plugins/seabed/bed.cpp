// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/seabed/bed.hpp"

namespace netloft::seabed {

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
  const Plane::Depth depth = Plane::press(b.height + p.radius - s.x[0].z, p.softness);
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

}  // namespace netloft::seabed
