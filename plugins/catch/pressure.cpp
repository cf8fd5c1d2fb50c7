// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/catch/pressure.hpp"

#include "plugins/catch/front_growth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace netloft::catches {

namespace {

constexpr int kFront = 9;           // degree of freedom of m, which is x of the last node
constexpr int kAxes[] = {1, 0, 2};  // y, x and z, in the order of the choices of `across`

struct Skew {
  double at[3][3];
};
Skew cross_matrix(const Vec3<double>& w) { return {{{0, -w.z, w.y}, {w.z, 0, -w.x}, {-w.y, w.x, 0}}}; }

/// The side w_j of the triangle opposite to corner j, by (4) of pressure.hpp.
Vec3<double> opposite(const State<4>& s, int j) {
  return s.x[static_cast<std::size_t>((j + 1) % 3)] - s.x[static_cast<std::size_t>((j + 2) % 3)];
}

double front(const State<4>& s) { return s.x[3].x; }

/// The quantities of one triangle in (6) to (9) of pressure.hpp.
struct FilledSlice {
  FilledSlice(const Pressure::Parameters& p, double o, const State<4>& s)
      : axis(kAxes[p.across]),
        n(o * cross(s.x[1] - s.x[0], s.x[2] - s.x[0])[axis]),
        arm((s.x[0][axis] + s.x[1][axis] + s.x[2][axis]) / 3 - p.middle) {}
  double volume() const { return arm * n / 2; }  // (6)
  int axis;
  double n, arm;
};

/// A cut through a triangle at `depth` meshes from one corner; the other two corners are `first` and `second`
/// meshes from the same corner. As the number m of filled meshes grows, the cut moves away from this corner
/// (`away` = 1) or towards it (`away` = −1).
struct Cut {
  double depth, first, second, away;
};

/// The fractions (5) of pressure.hpp, for the corner piece that the front cuts off at corner[0].
Pressure::Fraction cut_off(const std::array<std::size_t, 3>& corner, const Cut& cut) {
  const double t1 = cut.depth / cut.first, t2 = cut.depth / cut.second;  // fractions of the two sides
  const double d1 = cut.away / cut.first, d2 = cut.away / cut.second;    // derivatives with respect to m
  const double area = t1 * t2, d_area = d1 * t2 + t1 * d2;
  Pressure::Fraction fraction;
  fraction.at[corner[0]] = area * (3 - t1 - t2) / 3;
  fraction.at[corner[1]] = area * t1 / 3;
  fraction.at[corner[2]] = area * t2 / 3;
  fraction.slope_at[corner[0]] = (d_area * (3 - t1 - t2) - area * (d1 + d2)) / 3;
  fraction.slope_at[corner[1]] = (d_area * t1 + area * d1) / 3;
  fraction.slope_at[corner[2]] = (d_area * t2 + area * d2) / 3;
  return fraction;
}

/// Adds the force (3) of pressure.hpp and its tangent. `pressure` is p times the sign o.
void push(double pressure, const Pressure::Fraction& fraction, const State<4>& s, Local<4>& out) {
  const double half = pressure / 2;
  const Vec3<double> n = cross(s.x[1] - s.x[0], s.x[2] - s.x[0]);  // normal n of (2), without the sign o
  for (std::size_t i = 0; i < 3; ++i) out.force[i] = -(fraction.at[i] * half) * n;  // (3)
  if (!s.wants_tangent) return;
  for (int j = 0; j < 3; ++j) {
    const Skew turn = cross_matrix((s.cu * half) * opposite(s, j));
    for (std::size_t r = 0; r < 9; ++r)
      for (int c = 0; c < 3; ++c) out.tangent[r][3 * j + c] = fraction.at[r / 3] * turn.at[r % 3][c];  // (4)
  }
  for (std::size_t r = 0; r < 9; ++r)
    out.tangent[r][kFront] = -s.cu * fraction.slope_at[r / 3] * half * n[static_cast<int>(r % 3)];  // (8)
}

void balance_volume(const Pressure::Parameters& p, double pressure, double triangles, double o,
                    const Pressure::Fraction& fraction, const State<4>& s, Local<4>& out) {
  const FilledSlice slice(p, o, s);
  const double k = pressure / std::cbrt(p.volume);
  out.force[3].x = k * (fraction.value() * slice.volume() -
                        in_time::factor_at(p.growth, s.time) * p.volume / triangles);  // (7)
  if (!s.wants_tangent) return;
  out.tangent[kFront][kFront] = s.cu * k * fraction.slope() * slice.volume();  // (8)
  for (int j = 0; j < 3; ++j) {
    const Skew turn = cross_matrix((0.5 * o * slice.arm) * opposite(s, j));
    for (int c = 0; c < 3; ++c)
      out.tangent[kFront][3 * j + c] = s.cu * k * fraction.value() *
                                       ((c == slice.axis ? slice.n / 6 : 0) - turn.at[slice.axis][c]);  // (9)
  }
}

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number);
  return text;
}

}  // namespace

void Pressure::check(const Parameters& p, const Data&) {
  if (p.pressure == 0 && p.speed * p.drag_coefficient == 0)
    throw std::invalid_argument(
        "the catch exerts no pressure: give catch.pressure, or catch.speed (and a catch.drag_coefficient "
        "that is not zero)");
  if (p.meshes == 0 && p.volume == 0)
    throw std::invalid_argument(
        "the catch has no size: give catch.meshes, the number of filled meshes along, or catch.volume");
  if (p.meshes != 0 && p.volume != 0)
    throw std::invalid_argument(
        "the front of the catch is given twice: give either catch.meshes or catch.volume");
  check_growth(p.growth, p.volume);
}

void Pressure::check_whole(const Parameters& p, const Whole& whole) {
  if (p.meshes > whole.length * (1 + 1e-9))
    throw std::invalid_argument("catch.meshes = " + text_of(p.meshes) +
                                " is more than the length of the netting, " + text_of(whole.length) +
                                " meshes");
}

void Pressure::gather(const Parameters&, const Data& d, Whole& whole) {
  ++whole.triangles;
  for (const double s : d.to_aft) whole.length = std::max(whole.length, s);
}

double Pressure::first_front(const Parameters& p, const Whole& whole) {
  return p.volume > 0 ? 0.25 * whole.length : p.meshes;
}

Pressure::Fraction Pressure::fraction_behind_front(const std::array<double, 3>& to_aft, double meshes) {
  std::array<std::size_t, 3> corner{0, 1, 2};
  std::sort(corner.begin(), corner.end(), [&](auto i, auto j) { return to_aft[i] < to_aft[j]; });
  const double a = to_aft[corner[0]], b = to_aft[corner[1]], c = to_aft[corner[2]];
  constexpr double kThird = 1.0 / 3;
  if (meshes >= c) return {{kThird, kThird, kThird}, {}};
  if (meshes <= a) return {};
  if (meshes <= b) return cut_off(corner, {meshes - a, b - a, c - a, 1});
  std::swap(corner[0], corner[2]);
  Fraction fraction = cut_off(corner, {c - meshes, c - b, c - a, -1});
  for (std::size_t i = 0; i < 3; ++i) {
    fraction.at[i] = kThird - fraction.at[i];
    fraction.slope_at[i] *= -1;
  }
  return fraction;
}

double Pressure::full(const Parameters& p, const Water& w) {
  return p.pressure + 0.5 * w.density * p.drag_coefficient * p.speed * p.speed;  // (1)
}

double Pressure::on(const Parameters& p, const Data& d, const State<4>& s) {
  return fraction_behind_front(d.to_aft, front(s)).value() * full(p, s.water);
}

double Pressure::volume(const Parameters& p, const Data& d, const State<4>& s) {
  return fraction_behind_front(d.to_aft, front(s)).value() * FilledSlice(p, d.outward, s).volume();
}

Status Pressure::Push::evaluate(const Parameters& p, const Data& d, const Whole& whole, const State<4>& s,
                                Local<4>& out) {
  if (p.volume > 0 && !(front(s) >= 0 && front(s) <= whole.length))
    throw OutsideDomain("the front of the catch has left its netting, which may be too small for the volume");
  const Fraction fraction = fraction_behind_front(d.to_aft, front(s));
  const double pressure = full(p, s.water);
  push(d.outward * pressure, fraction, s, out);
  if (p.volume > 0) balance_volume(p, pressure, whole.triangles, d.outward, fraction, s, out);
  return Status::ok;
}

}  // namespace netloft::catches
