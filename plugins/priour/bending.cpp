// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/bending.hpp"

namespace netloft::priour {

namespace {

constexpr double kNoArea = 1e-12;  // ‖N‖ over the product of its edges
constexpr double kFolded = 1e-12;  // (1 + c)/2

/// |d| of triangle (1) between the edge and corner k.
double bars_beside(const Bending::Data& d, std::size_t k) {
  return std::abs((d.u[1] - d.u[0]) * (d.v[k] - d.v[0]) - (d.u[k] - d.u[0]) * (d.v[1] - d.v[0]));
}

/// (1), (2) at a state.
struct Fold {
  explicit Fold(const State<4>& s) : e{s.x[1] - s.x[0], s.x[2] - s.x[0], s.x[3] - s.x[0]} {
    const Vec3<double> N[2] = {cross(e[0], e[1]), cross(e[2], e[0])};
    for (int k = 0; k < 2; ++k) {
      l[k] = norm(N[k]);
      has_area = has_area && l[k] > kNoArea * norm(e[0]) * norm(e[k + 1]);
      n[k] = (1 / l[k]) * N[k];
    }
    const Vec3<double> turn = n[1] - n[0];
    h = 0.25 * dot(turn, turn);
    c = 1 - 2 * h;
    p[0] = turn - dot(n[0], turn) * n[0];  // N̂₂ − c N̂₁, all digits kept where it is flat
    p[1] = dot(n[1], turn) * n[1] - turn;
  }
  Vec3<double> e[3], n[2], p[2];
  double l[2], c = 1, h = 0;  // h = (1 − c)/2
  bool has_area = true;
};

/// ∂²E/∂N_a∂N_b, entry (r, s): angle (4), (5).
double curvature(const Fold& f, double E1, double E2, int a, int b, int r, int s) {
  const double one = r == s ? 1 : 0;
  const auto square = [&](int k) { return f.n[k][r] * f.n[k][s]; };
  if (a == b)
    return (E2 * f.p[a][r] * f.p[a][s] -
            E1 * (f.p[a][r] * f.n[a][s] + f.n[a][r] * f.p[a][s] + f.c * (one - square(a)))) /
           (f.l[a] * f.l[a]);
  return (E2 * f.p[a][r] * f.p[b][s] + E1 * (one - square(0) - square(1) + f.c * f.n[a][r] * f.n[b][s])) /
         (f.l[0] * f.l[1]);
}

/// Entry (r, s) of [w]×.
double cross_matrix(const Vec3<double>& w, int r, int s) {
  if (r == s) return 0;
  return ((s - r + 3) % 3 == 1 ? -1 : 1) * w[3 - r - s];
}

using Square6 = double[6][6];
using Square9 = double[9][9];

void fill_curvature(const Fold& f, double E1, double E2, Square6& H) {
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int r = 0; r < 3; ++r)
        for (int s = 0; s < 3; ++s) H[3 * a + r][3 * b + s] = curvature(f, E1, E2, a, b, r, s);
}

/// ∂(N₁, N₂)/∂(e₀, e₁, e₂): −[e₁]×, [e₀]×, 0 and [e₂]×, 0, −[e₀]×.
void fill_jacobian(const Fold& f, double (&J)[6][9]) {
  for (int r = 0; r < 3; ++r)
    for (int s = 0; s < 3; ++s) {
      J[r][s] = -cross_matrix(f.e[1], r, s), J[r][3 + s] = cross_matrix(f.e[0], r, s), J[r][6 + s] = 0;
      J[3 + r][s] = cross_matrix(f.e[2], r, s), J[3 + r][3 + s] = 0, J[3 + r][6 + s] = -J[r][3 + s];
    }
}

/// K = Jᵀ H J + what the second derivatives of N add, with G = ∂E/∂N.
void fill_tangent(const Fold& f, const Vec3<double> (&G)[2], double E1, double E2, Square9& K) {
  Square6 H;
  double J[6][9], HJ[6][9];
  fill_curvature(f, E1, E2, H);
  fill_jacobian(f, J);
  for (int r = 0; r < 6; ++r)
    for (int s = 0; s < 9; ++s) {
      HJ[r][s] = 0;
      for (int k = 0; k < 6; ++k) HJ[r][s] += H[r][k] * J[k][s];
    }
  for (int r = 0; r < 9; ++r)
    for (int s = 0; s < 9; ++s) {
      K[r][s] = 0;
      for (int k = 0; k < 6; ++k) K[r][s] += J[k][r] * HJ[k][s];
    }
  for (int r = 0; r < 3; ++r)
    for (int s = 0; s < 3; ++s) {
      K[r][3 + s] -= cross_matrix(G[0], r, s), K[3 + r][s] += cross_matrix(G[0], r, s);
      K[r][6 + s] += cross_matrix(G[1], r, s), K[6 + r][s] -= cross_matrix(G[1], r, s);
    }
}

/// From the three edges to the four corners: e_k = x_{k+1} − x_a.
void spread(const Square9& K, double cu, Local<4>& out) {
  for (int r = 0; r < 9; ++r)
    for (int s = 0; s < 9; ++s) {
      const double k = cu * K[r][s];
      out.tangent[3 + r][3 + s] += k;
      out.tangent[r % 3][3 + s] -= k, out.tangent[3 + r][s % 3] -= k;
      out.tangent[r % 3][s % 3] += k;
    }
}

}  // namespace

double Bending::kappa(const Parameters& p, const Data& d) {
  const double du = d.u[1] - d.u[0], dv = d.v[1] - d.v[0], sine = std::sin(2 * p.half_angle);
  const double edge = std::sqrt(du * du + dv * dv + 2 * du * dv * std::cos(2 * p.half_angle));  // b/l₀
  double h = 0;
  for (std::size_t side = 0; side < 2; ++side)
    h += bars_beside(d, 2 + side) * d.bar_length[side] * sine / edge;  // (5)
  const double across = std::abs(du * du * du) + std::abs(dv * dv * dv);
  return 4 * p.EI * across * (sine / edge) * (sine / edge) / h;  // (6), (3)
}

double Bending::turning_angle(const State<4>& s) {
  const Vec3<double> e = s.x[1] - s.x[0], N1 = cross(e, s.x[2] - s.x[0]), N2 = cross(s.x[3] - s.x[0], e);
  return std::atan2(norm(cross(N1, N2)), dot(N1, N2));
}

void Bending::check(const Parameters&, const Data& d) {
  for (std::size_t side = 0; side < 2; ++side)
    if (!(d.bar_length[side] > 0 && bars_beside(d, 2 + side) > 0))
      throw std::invalid_argument("a triangle that holds no netting has no altitude over its edge");
}

Status Bending::Elastic::evaluate(const Parameters& p, const Data& d, const State<4>& s, Local<4>& out) {
  if (p.EI == 0) return Status::ok;
  const Fold f(s);
  if (!f.has_area || !(1 - f.h > kFolded)) return Status::outside_domain;
  const double k = kappa(p, d), E1 = -k / (1 + f.c), E2 = k / ((1 + f.c) * (1 + f.c));
  out.energy = -k * std::log1p(-f.h);  // (3)
  const Vec3<double> G[2] = {(E1 / f.l[0]) * f.p[0], (E1 / f.l[1]) * f.p[1]};
  out.force[1] = cross(f.e[1], G[0]) - cross(f.e[2], G[1]);
  out.force[2] = cross(G[0], f.e[0]);
  out.force[3] = cross(f.e[0], G[1]);
  out.force[0] = -(out.force[1] + out.force[2] + out.force[3]);
  if (!s.wants_tangent) return Status::ok;
  Square9 K;
  fill_tangent(f, G, E1, E2, K);
  spread(K, s.cu, out);
  return Status::ok;
}

}  // namespace netloft::priour
