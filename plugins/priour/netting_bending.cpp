// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/netting_bending.hpp"

#include "plugins/priour/triangle.hpp"

namespace netloft::priour {

namespace {

/// The determinant |d| of triangle.hpp (1), twice the number of bars of one direction, for the triangle
/// between the common edge and corner `k`.
double bars_beside(const Bending::Data& d, std::size_t k) {
  return std::abs(Triangle::determinant(d.u, d.v, k));
}

/// The function L(w) of (3) and (5) in netting_bending.hpp and its derivatives, from h = 1 − w.
struct Logarithm {
  explicit Logarithm(double h) {
    const double w = 1 - h, w0 = Bending::kFolded;
    if (w >= w0) {
      L = std::log1p(-h);
      L1 = 1 / w;
      L2 = -L1 * L1;
    } else {
      const double z = w / w0 - 1;
      L = std::log(w0) + z - 0.5 * z * z;
      L1 = (1 - z) / w0;
      L2 = -1 / (w0 * w0);
    }
  }
  double L, L1, L2;
};

constexpr double kSign[2] = {1, -1};  // sign σ of each triangle

/// The quantities of (1)–(3) and (8) in netting_bending.hpp, at one state of the two triangles.
struct Fold {
  Fold(const State<4>& state, const Bending::Flat& flat)
      : e{state.x[1] - state.x[0], state.x[2] - state.x[0], state.x[3] - state.x[0]} {
    const Vec3<double> N[2] = {cross(e[0], e[1]), cross(e[2], e[0])};
    for (int k = 0; k < 2; ++k) {
      const double fade = Bending::kClosed * flat.M[k];
      s[k] = std::sqrt(dot(N[k], N[k]) + fade * fade);
      n[k] = (1 / s[k]) * N[k];
    }
    q = n[0] - n[1];
    const Logarithm log(0.25 * dot(q, q));
    E = -flat.kappa * log.L;
    D1 = flat.kappa * log.L1;
    D2 = -flat.kappa * log.L2;
    for (int k = 0; k < 2; ++k) {
      const Vec3<double> g = (0.5 * D1 * kSign[k]) * q;
      normal[k] = dot(g, n[k]);
      p[k] = g - normal[k] * n[k];
      G[k] = (1 / s[k]) * p[k];
    }
  }
  Vec3<double> e[3], n[2], q, p[2], G[2];
  double s[2], normal[2], E, D1, D2;  // normal: g·n
};

/// Fills in ∂²E/∂N_a∂N_b by (9) of netting_bending.hpp.
void fill_block(const Fold& f, int a, int b, double (&H)[6][6]) {
  const Vec3<double> qa = f.q - dot(f.q, f.n[a]) * f.n[a], qb = f.q - dot(f.q, f.n[b]) * f.n[b];
  const double k = kSign[a] * kSign[b] / (f.s[a] * f.s[b]), nn = dot(f.n[a], f.n[b]);
  for (int r = 0; r < 3; ++r)
    for (int s = 0; s < 3; ++s) {
      const double one = r == s ? 1 : 0, naa = f.n[a][r] * f.n[a][s], nbb = f.n[b][r] * f.n[b][s];
      double H_rs =
          k * (0.5 * f.D1 * (one - naa - nbb + nn * f.n[a][r] * f.n[b][s]) + 0.25 * f.D2 * qa[r] * qb[s]);
      if (a == b)
        H_rs -=
            (f.n[a][r] * f.p[a][s] + f.p[a][r] * f.n[a][s] + f.normal[a] * (one - naa)) / (f.s[a] * f.s[a]);
      H[3 * a + r][3 * b + s] = H_rs;
    }
}

/// Entry (r, s) of the matrix [w]× with [w]× v = w×v.
double cross_matrix(const Vec3<double>& w, int r, int s) {
  if (r == s) return 0;
  return ((s - r + 3) % 3 == 1 ? -1 : 1) * w[3 - r - s];
}

using Square6 = double[6][6];
using Square9 = double[9][9];

/// The Jacobian ∂(N₁, N₂)/∂(e₀, e₁, e₂): −[e₁]×, [e₀]×, 0 and [e₂]×, 0, −[e₀]×.
void fill_jacobian(const Fold& f, double (&J)[6][9]) {
  for (int r = 0; r < 3; ++r)
    for (int s = 0; s < 3; ++s) {
      J[r][s] = -cross_matrix(f.e[1], r, s), J[r][3 + s] = cross_matrix(f.e[0], r, s), J[r][6 + s] = 0;
      J[3 + r][s] = cross_matrix(f.e[2], r, s), J[3 + r][3 + s] = 0, J[3 + r][6 + s] = -J[r][3 + s];
    }
}

/// Computes the tangent for the three edges: Jᵀ H J, where H are the second derivatives (9) and J is the
/// Jacobian above, plus the terms from the second derivatives of N.
void fill_tangent(const Fold& f, Square9& K) {
  Square6 H;
  double J[6][9], HJ[6][9];
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) fill_block(f, a, b, H);
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
      K[r][3 + s] -= cross_matrix(f.G[0], r, s), K[3 + r][s] += cross_matrix(f.G[0], r, s);
      K[r][6 + s] += cross_matrix(f.G[1], r, s), K[6 + r][s] -= cross_matrix(f.G[1], r, s);
    }
}

/// Distributes the matrix of the three edge vectors e_k = x_{k+1} − x_a to the four corners.
void spread(const Square9& K, double cu, Local<4>& out) {
  for (int r = 0; r < 9; ++r)
    for (int s = 0; s < 9; ++s) {
      const double k = cu * K[r][s];
      out.tangent[3 + r][3 + s] += k;
      out.tangent[r % 3][3 + s] -= k;
      out.tangent[3 + r][s % 3] -= k;
      out.tangent[r % 3][s % 3] += k;
    }
}

}  // namespace

Bending::Flat Bending::flat(const Parameters& p, const Data& d) {
  const double du = d.u[1] - d.u[0], dv = d.v[1] - d.v[0], sine = std::sin(2 * p.half_angle);
  const double edge = std::sqrt(du * du + dv * dv + 2 * du * dv * std::cos(2 * p.half_angle));  // b/l₀
  Flat flat{};
  double altitudes = 0;
  for (std::size_t side = 0; side < 2; ++side) {  // (6)
    const double l0 = d.bar_length[side];
    flat.M[side] = bars_beside(d, 2 + side) * l0 * l0 * sine;
    altitudes += flat.M[side] / (edge * l0);
  }
  const double across = std::abs(du * du * du) + std::abs(dv * dv * dv);
  flat.kappa = 4 * p.EI * across * (sine / edge) * (sine / edge) / altitudes;  // (7), (3)
  return flat;
}

double Bending::turning_angle(const State<4>& s) {
  const Vec3<double> e = s.between(0, 1), N1 = cross(e, s.between(0, 2)), N2 = cross(s.between(0, 3), e);
  return std::atan2(norm(cross(N1, N2)), dot(N1, N2));
}

void Bending::check(const Parameters&, const Data& d) {
  for (std::size_t side = 0; side < 2; ++side)
    if (!(d.bar_length[side] > 0 && bars_beside(d, 2 + side) > 0))
      throw std::invalid_argument("a triangle that holds no netting has no altitude over its edge");
}

Status Bending::Elastic::evaluate(const Parameters& p, const Data& d, const State<4>& s, Local<4>& out) {
  if (p.EI == 0) return Status::ok;
  const Fold f(s, flat(p, d));
  out.energy = f.E;
  out.force[1] = cross(f.e[1], f.G[0]) - cross(f.e[2], f.G[1]);
  out.force[2] = cross(f.G[0], f.e[0]);
  out.force[3] = cross(f.e[0], f.G[1]);
  out.force[0] = -(out.force[1] + out.force[2] + out.force[3]);
  if (!s.wants_tangent) return Status::ok;
  Square9 K;
  fill_tangent(f, K);
  spread(K, s.cu, out);
  return Status::ok;
}

}  // namespace netloft::priour
