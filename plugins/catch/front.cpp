// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/catch/front.hpp"

#include "plugins/catch/front_growth.hpp"

#include <cmath>

namespace netloft::catches {

namespace {

constexpr int kUnknowns = 10;  // nine coordinates and ξ

/// The part of a triangle behind the plane by (4) of front.hpp, the normal (2) and the volume (6). If the
/// number type T has derivatives, so have the results.
template <class T>
struct Slice {
  Slice(const Front::Parameters& p, const Front::Data& d, const Points<T, 3>& x, const T& front) {
    const double ex = std::cos(p.direction), ey = std::sin(p.direction);
    std::array<T, 3> s;
    for (std::size_t i = 0; i < 3; ++i) s[i] = ex * x[i].x + ey * x[i].y - front;
    behind = Front::behind(s);
    n = d.outward * cross(x[1] - x[0], x[2] - x[0]);
    volume = behind.I * (0.5 * ex * n.x + 0.5 * ey * n.y);
  }
  Front::Behind<T> behind;
  Vec3<T> n;
  T volume{};
};

using Tangent = Dual<kUnknowns, 1>;

Slice<Tangent> slice_of(const Front::Parameters& p, const Front::Data& d, const State<4>& s) {
  Points<Tangent, 3> x;
  for (int i = 0; i < 9; ++i)
    x[static_cast<std::size_t>(i / 3)][i % 3] =
        Tangent::variable(s.x[static_cast<std::size_t>(i / 3)][i % 3], i);
  return {p, d, x, Tangent::variable(s.x[3].x, 9)};
}

Slice<double> plain_slice_of(const Front::Parameters& p, const Front::Data& d, const State<4>& s) {
  return {p, d, {s.x[0], s.x[1], s.x[2]}, s.x[3].x};
}

void put(const Tangent& residual, int row, const State<4>& s, Local<4>& out) {
  out.force[static_cast<std::size_t>(row / 3)][row % 3] = residual.value;
  for (std::size_t c = 0; c < kUnknowns; ++c) out.tangent[row][c] = s.cu * residual.gradient[c];
}

}  // namespace

void Front::check(const Parameters& p, const Data&) {
  if (p.pressure == 0 && p.speed * p.drag_coefficient == 0)
    throw std::invalid_argument(
        "the catch exerts no pressure: give catch.pressure, or catch.speed (and a catch.drag_coefficient "
        "that is not zero)");
  check_growth(p.growth, p.volume);
}

double Front::full(const Parameters& p, const Water& w) {
  return p.pressure + 0.5 * w.density * p.drag_coefficient * p.speed * p.speed;  // (1)
}

double Front::volume(const Parameters& p, const Data& d, const State<4>& s) {
  return plain_slice_of(p, d, s).volume;
}

double Front::on(const Parameters& p, const Data& d, const State<4>& s) {
  const auto slice = plain_slice_of(p, d, s);
  return full(p, s.water) * (slice.behind.w[0] + slice.behind.w[1] + slice.behind.w[2]);
}

Status Front::Push::evaluate(const Parameters& p, const Data& d, const Whole& whole, const State<4>& s,
                             Local<4>& out) {
  const auto slice = slice_of(p, d, s);
  const double pressure = full(p, s.water);
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis)
      put((-0.5 * pressure) * (slice.behind.w[static_cast<std::size_t>(i)] * slice.n[axis]), 3 * i + axis, s,
          out);  // (5)
  if (p.volume > 0)
    put((pressure / std::cbrt(p.volume)) *
            (in_time::factor_at(p.growth, s.time) * p.volume / whole.triangles - slice.volume),
        9, s, out);  // (7)
  return Status::ok;
}

}  // namespace netloft::catches
