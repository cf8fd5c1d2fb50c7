// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/rope/clamp.hpp"

#include "plugins/rope/rope_bending.hpp"

#include <cmath>

namespace netloft::rope {

namespace {

constexpr double kInLine = 1e-9;          // value of sin φ below which the bars are in line
constexpr double kFoldedAtClamp = 1e-12;  // value of (1 + cos δ)/2 below which they are folded

/// E and its derivatives with respect to φ [J].
OfCosine over_angle(const Clamp::Parameters& p, const Clamp::Data& d, double delta) {
  const double a = d.rest_length[0], b = d.rest_length[1], c = std::cos(delta), s = std::sin(delta);
  if (p.curvature == Clamp::of_bars) {  // (2)
    const double k = 4 * p.EI / (a + b), half = std::cos(0.5 * delta);
    return {-2 * k * std::log(half), k * std::tan(0.5 * delta), 0.5 * k / (half * half)};
  }
  const double Q = a * a + b * b + 2 * a * b * c, chord = std::sqrt(Q);  // (3)
  return {4 * p.EI * (1 - c) / (a + b + chord), 2 * p.EI * s / chord,
          2 * p.EI * (c / chord + s * s * a * b / (Q * chord))};
}

}  // namespace

Status Clamp::Elastic::evaluate(const Parameters& p, const Data& d, const State<3>& s, Local<3>& out) {
  if (p.angle == 0) return Bending::Elastic::evaluate({p.EI, p.curvature}, {d.rest_length}, s, out);
  if (p.EI == 0) return Status::ok;
  const Turn q(s);
  if (!q.is_inside(d.rest_length)) return Status::outside_domain;
  const double sine = norm(cross(q.t[0], q.t[1])), delta = std::atan2(sine, q.c) - p.angle;
  if (!(sine > kInLine) && q.c > 0) {
    out.energy = over_angle(p, d, delta).E;
    return Status::ok;
  }
  if (!(sine > kInLine) || !(0.5 + 0.5 * std::cos(delta) > kFoldedAtClamp)) return Status::outside_domain;
  const OfCosine f = over_angle(p, d, delta);
  add_of_cosine(q, {f.E, -f.E1 / sine, (f.E2 - f.E1 * q.c / sine) / (sine * sine)}, s, out);  // (4)
  return Status::ok;
}

}  // namespace netloft::rope
