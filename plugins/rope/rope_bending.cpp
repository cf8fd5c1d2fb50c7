// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/rope/rope_bending.hpp"

#include <cmath>

namespace netloft::rope {

namespace {

constexpr double kFolded = 1e-12;  // value of (1 + c)/2 below which a rope is folded back on itself

OfCosine energy_of(const Bending::Parameters& p, const Bending::Data& d, const Turn& q) {
  if (p.curvature == Bending::of_bars) {  // (1)
    const double k = Bending::kappa(p, d);
    return {-k * std::log1p(-q.h), -k / (1 + q.c), k / ((1 + q.c) * (1 + q.c))};
  }
  const double sum = d.rest_length[0] + d.rest_length[1], product = d.rest_length[0] * d.rest_length[1];
  const double chord = std::sqrt(sum * sum - 4 * product * q.h);  // √Q of (4)
  return {8 * p.EI * q.h / (sum + chord), -2 * p.EI / chord, 2 * p.EI * product / (chord * chord * chord)};
}

}  // namespace

double Bending::turning_angle(const State<3>& s) {
  const Vec3<double> w1 = s.between(0, 1), w2 = s.between(1, 2);
  return std::atan2(norm(cross(w1, w2)), dot(w1, w2));
}

Status Bending::Elastic::evaluate(const Parameters& p, const Data& d, const State<3>& s, Local<3>& out) {
  if (p.EI == 0) return Status::ok;
  const Turn q(s);
  if (!q.is_inside(d.rest_length) || !(1 - q.h > kFolded)) return Status::outside_domain;
  add_of_cosine(q, energy_of(p, d, q), s, out);
  return Status::ok;
}

}  // namespace netloft::rope
