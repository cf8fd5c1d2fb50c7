// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/knot_contact.hpp"

namespace netloft::priour {

double KnotContact::depth(const Triangle::Parameters& p, const Triangle::Data& d, const State<3>& s) {
  if (p.knot_size == 0) return 0;
  const double touch = Triangle::touching_cosine(p, d),
               c = std::abs(std::cos(2 * Triangle::half_angle(d, s)));
  return std::max(0.0, (c - touch) / (1 - touch));  // (2)
}

Status KnotContact::tile(const Family<Triangle>& family, netloft_tile& t) {
  const Triangle::Lanes& p = family.lanes(t);
  const angle::Meshes m(p, t);
  angle::Function f;
  for (std::size_t i = 0; i < t.count; ++i) {
    const double width = 1 - p.touching[i];  // zero without knots
    const double over = std::max(std::abs(m.c[i]) - p.touching[i], 0.0);
    const double y = over / std::max(width, 1e-300), K = width > 0 ? p.bars[i] * p.EA[i] * p.l0[i] : 0;
    f.E[i] = K * width * y * y * y;  // (3)
    f.E1[i] = (m.c[i] < 0 ? -3 : 3) * K * y * y;
    f.E2[i] = 6 * K * over / std::max(width * width, 1e-300);
  }
  angle::add(p, m, f, t);
  return Status::ok;
}

}  // namespace netloft::priour
