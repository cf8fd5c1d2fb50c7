// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/catch/pressure.hpp"

#include <algorithm>

namespace netloft::catches {

double Pressure::share_behind_front(const std::array<double, 3>& to_aft, double meshes) {
  auto [a, b, c] = to_aft;
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  if (meshes >= c) return 1;
  if (meshes <= a) return 0;
  if (meshes <= b) return (meshes - a) * (meshes - a) / ((b - a) * (c - a));
  return 1 - (c - meshes) * (c - meshes) / ((c - b) * (c - a));
}

double Pressure::on(const Parameters& p, const Data& d, const Water& w) {
  const double pressure = p.pressure + 0.5 * w.density * p.drag_coefficient * p.speed * p.speed;  // (1)
  return share_behind_front(d.to_aft, p.meshes) * pressure;
}

Status Pressure::Push::evaluate(const Parameters& p, const Data& d, const State<3>& s, Local<3>& out) {
  const double sixth = on(p, d, s.water) / 6;
  const Vec3<double> n = cross(s.x[1] - s.x[0], s.x[2] - s.x[0]);  // (2)
  for (auto& r : out.force) r = -sixth * n;                        // (3)
  if (!s.wants_tangent) return Status::ok;
  for (int j = 0; j < 3; ++j) {
    const auto next = static_cast<std::size_t>((j + 1) % 3), last = static_cast<std::size_t>((j + 2) % 3);
    const Vec3<double> w = (s.cu * sixth) * (s.x[next] - s.x[last]);
    const double turn[3][3] = {{0, -w.z, w.y}, {w.z, 0, -w.x}, {-w.y, w.x, 0}};
    for (int r = 0; r < 9; ++r)
      for (int c = 0; c < 3; ++c) out.tangent[r][3 * j + c] = turn[r % 3][c];  // (4)
  }
  return Status::ok;
}

}  // namespace netloft::catches
