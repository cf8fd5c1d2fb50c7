// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/rope/bending.hpp"

namespace netloft::rope {

namespace {

constexpr double kShortest = 1e-9;  // bar over its unstretched length
constexpr double kFolded = 1e-12;   // (1 + c)/2

/// (1) and (4) of a pair of bars.
struct Turn {
  explicit Turn(const State<3>& s) {
    const Vec3<double> w[2] = {s.between(0, 1), s.between(1, 2)};
    for (int k = 0; k < 2; ++k) l[k] = norm(w[k]), t[k] = (1 / l[k]) * w[k];
    const Vec3<double> d = t[1] - t[0];
    h = 0.25 * dot(d, d);
    c = 1 - 2 * h;
    g[0] = (1 / l[0]) * (d - dot(t[0], d) * t[0]);
    g[1] = (-1 / l[1]) * (d - dot(t[1], d) * t[1]);
  }
  double l[2], h = 0, c = 1;  // h = (1 − c)/2
  Vec3<double> t[2], g[2];
};

/// ∂²c/∂w_a∂w_b, (5) and (6).
double second(const Turn& q, int a, int b, int r, int s) {
  const auto across = [&q](int k, int i, int j) { return (i == j ? 1 : 0) - q.t[k][i] * q.t[k][j]; };
  if (a == b)
    return -(q.t[a][r] * q.g[a][s] + q.g[a][r] * q.t[a][s]) / q.l[a] -
           q.c * across(a, r, s) / (q.l[a] * q.l[a]);
  double product = 0;
  for (int k = 0; k < 3; ++k) product += across(a, r, k) * across(b, k, s);
  return product / (q.l[0] * q.l[1]);
}

/// The dependence of the two chords on node p: w_k = Σ kChord[k][p] x_p.
constexpr double kChord[2][3] = {{-1, 1, 0}, {0, -1, 1}};

}  // namespace

double Bending::turning_angle(const State<3>& s) {
  const Vec3<double> w1 = s.between(0, 1), w2 = s.between(1, 2);
  return std::atan2(norm(cross(w1, w2)), dot(w1, w2));
}

Status Bending::Elastic::evaluate(const Parameters& p, const Data& d, const State<3>& s, Local<3>& out) {
  if (p.EI == 0) return Status::ok;
  const Turn q(s);
  const bool inside = q.l[0] > kShortest * d.rest_length[0] && q.l[1] > kShortest * d.rest_length[1];
  if (!inside || !(1 - q.h > kFolded)) return Status::outside_domain;
  const double k = kappa(p, d), first = -k / (1 + q.c), curved = k / ((1 + q.c) * (1 + q.c));
  out.energy = -k * std::log1p(-q.h);  // (2)
  for (std::size_t n = 0; n < 3; ++n)
    out.force[n] = (first * kChord[0][n]) * q.g[0] + (first * kChord[1][n]) * q.g[1];
  if (!s.wants_tangent) return Status::ok;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
          const double H = s.cu * (curved * q.g[a][r] * q.g[b][c] + first * second(q, a, b, r, c));
          for (int n = 0; n < 3; ++n)
            for (int m = 0; m < 3; ++m) out.tangent[3 * n + r][3 * m + c] += kChord[a][n] * kChord[b][m] * H;
        }
  return Status::ok;
}

}  // namespace netloft::rope
