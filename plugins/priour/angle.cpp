// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/angle.hpp"

namespace netloft::priour::angle {

Meshes::Meshes(const Triangle::Lanes& p, netloft_tile& tile) : u(tile, p.a, p.l0), v(tile, p.b, p.l0) {
  for (std::uint32_t i = 0; i < tile.count; ++i)
    if (u.collapsed(i, p.l0[i]) || v.collapsed(i, p.l0[i])) {
      tile.lane_at_fault = i;
      throw OutsideDomain("a twine of zero length has no angle with another twine");
    }
  for (std::size_t i = 0; i < tile.count; ++i) {
    const double ux = u.t[0][i], uy = u.t[1][i], uz = u.t[2][i];
    const double vx = v.t[0][i], vy = v.t[1][i], vz = v.t[2][i];
    const double wx = uy * vz - uz * vy, wy = uz * vx - ux * vz, wz = ux * vy - uy * vx;
    c[i] = ux * vx + uy * vy + uz * vz;  // (1)
    s[i] = std::sqrt(wx * wx + wy * wy + wz * wz);
  }
}

namespace {

/// The second derivatives E_UU, E_VV (six numbers each, in the order of axial::kPlace) and E_UV (nine
/// numbers) of every element, by (4) and (5) of angle.hpp.
struct Curvature {
  double uu[6][kLanes], vv[6][kLanes], uv[9][kLanes];
};

void add_force(const Triangle::Lanes& p, const Meshes& m, const Function& f, std::uint32_t count,
               double* __restrict force) {
  for (std::size_t i = 0; i < count; ++i) {
    const double c = m.c[i], gu = f.E1[i] * m.u.inverse[i], gv = f.E1[i] * m.v.inverse[i];
    for (int axis = 0; axis < 3; ++axis) {
      const double U = gu * (m.v.t[axis][i] - c * m.u.t[axis][i]),
                   V = gv * (m.u.t[axis][i] - c * m.v.t[axis][i]);
      for (int corner = 0; corner < 3; ++corner)  // (3)
        force[at(3 * corner + axis, i)] += p.a[corner][i] * U + p.b[corner][i] * V;
    }
  }
}

/// Fills in ∂²E/∂U² by (4) of angle.hpp, or ∂²E/∂V² if `own` contains the twines along V.
void fill_own(const Twines& own, const Twines& other, const Meshes& m, const Function& f, double cu,
              std::uint32_t count, double (&__restrict out)[6][kLanes]) {
  for (std::size_t i = 0; i < count; ++i) {
    const double c = m.c[i], k = cu * own.inverse[i] * own.inverse[i], e1 = k * f.E1[i], e2 = k * f.E2[i];
    double p[3];
    for (int r = 0; r < 3; ++r) p[r] = other.t[r][i] - c * own.t[r][i];
    for (int r = 0, n = 0; r < 3; ++r)
      for (int s = 0; s <= r; ++s, ++n) {
        const double wr = own.t[r][i], ws = own.t[s][i], one = r == s ? 1 : 0;
        out[n][i] = e2 * p[r] * p[s] - e1 * (p[r] * ws + wr * p[s] + c * (one - wr * ws));
      }
  }
}

/// Fills in ∂²E/∂U∂V by (5) of angle.hpp.
void fill_mixed(const Meshes& m, const Function& f, double cu, std::uint32_t count,
                double (&__restrict out)[9][kLanes]) {
  for (std::size_t i = 0; i < count; ++i) {
    const double c = m.c[i], k = cu * m.u.inverse[i] * m.v.inverse[i], e1 = k * f.E1[i], e2 = k * f.E2[i];
    for (int r = 0; r < 3; ++r)
      for (int s = 0; s < 3; ++s) {
        const double ur = m.u.t[r][i], us = m.u.t[s][i], vr = m.v.t[r][i], vs = m.v.t[s][i],
                     one = r == s ? 1 : 0;
        out[3 * r + s][i] = e2 * (vr - c * ur) * (us - c * vs) + e1 * (one - ur * us - vr * vs + c * ur * vs);
      }
  }
}

/// Adds `weight` · y yᵀ to the second derivatives; the six components of y are those of `U`, then those of
/// `V`.
void add_square(double weight, const Vec3<double>& U, const Vec3<double>& V, std::size_t i, Curvature& k) {
  for (int r = 0, n = 0; r < 3; ++r) {
    for (int s = 0; s <= r; ++s, ++n) {
      k.uu[n][i] += weight * U[r] * U[s];
      k.vv[n][i] += weight * V[r] * V[s];
    }
    for (int s = 0; s < 3; ++s) k.uv[3 * r + s][i] += weight * U[r] * V[s];
  }
}

/// A unit vector perpendicular to u, in the plane of u and v if they span one.
Vec3<double> across(const Vec3<double>& u, const Vec3<double>& v) {
  Vec3<double> p = v - dot(u, v) * u;
  if (norm(p) < 1e-12) {
    const Vec3<double> axis = std::abs(u.x) < 0.6 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0};
    p = axis - dot(u, axis) * u;
  }
  return (1 / norm(p)) * p;
}

/// Fills in the convex part (9) of angle.hpp.
void fill_convex(const Meshes& m, const Function& f, double cu, std::uint32_t count, Curvature& k) {
  k = {};
  for (std::size_t i = 0; i < count; ++i) {
    const double c = m.c[i], s = m.s[i], E1 = cu * f.E1[i], E2 = cu * f.E2[i];
    const double h1 = -s * E1, h2 = s * s * E2 - c * E1, rho = std::sqrt(h2 * h2 + h1 * h1);
    if (rho == 0) continue;
    const Vec3<double> u{m.u.t[0][i], m.u.t[1][i], m.u.t[2][i]}, v{m.v.t[0][i], m.v.t[1][i], m.v.t[2][i]};
    const Vec3<double> fu = across(u, v), w = cross(u, fu), fv = cross(w, v);
    const double iu = m.u.inverse[i], iv = m.v.inverse[i], lambda = h2 > 0 ? h2 + rho : h1 * h1 / (rho - h2);
    // The eigenvector (σ, μ) = (λ, −h′) of the eigenvalue λ = h″ + ρ has the squared length 2λρ, so that its
    // weight λ/(2λρ) is 1/(2ρ).
    add_square(0.25 / rho, iu * (-h1 * u - lambda * fu), iv * (-h1 * v + lambda * fv), i, k);
    const double sign = h1 > 0 ? 1 : -1;  // the eigenvector in (τ, κ) of (9)
    add_square(0.25 * std::abs(h1), iu * (fu + sign * u), iv * (fv - sign * v), i, k);
    const double out = E1 < 0 ? -E1 * (1 + c) : E1 * (1 - c);
    add_square(0.5 * std::max(out, 0.0), iu * w, (E1 < 0 ? -iv : iv) * w, i, k);
  }
}

/// Adds block (P, Q) of (6) in angle.hpp to the packed lower triangle of the tangent.
template <int P, int Q>
void add_block(const Triangle::Lanes& p, const Curvature& k, std::uint32_t count,
               double* __restrict tangent) {
  for (std::size_t i = 0; i < count; ++i) {
    const double aa = p.a[P][i] * p.a[Q][i], bb = p.b[P][i] * p.b[Q][i];
    const double ab = p.a[P][i] * p.b[Q][i], ba = p.b[P][i] * p.a[Q][i];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < (P == Q ? r + 1 : 3); ++c) {
        constexpr int row = 3 * P, column = 3 * Q;
        const int entry = (row + r) * (row + r + 1) / 2 + column + c, n = axial::kPlace[r][c];
        tangent[at(entry, i)] +=
            aa * k.uu[n][i] + bb * k.vv[n][i] + ab * k.uv[3 * r + c][i] + ba * k.uv[3 * c + r][i];
      }
  }
}

}  // namespace

void add(const Triangle::Lanes& p, const Meshes& m, const Function& f, netloft_tile& t) {
  if (t.energy)
    for (std::size_t i = 0; i < t.count; ++i) t.energy[i] += f.E[i];
  if (t.force) add_force(p, m, f, t.count, t.force);
  if (!t.tangent) return;
  Curvature k;
  if (t.want & NETLOFT_WANT_CONVEX) {
    fill_convex(m, f, t.cu, t.count, k);
  } else {
    fill_own(m.u, m.v, m, f, t.cu, t.count, k.uu);
    fill_own(m.v, m.u, m, f, t.cu, t.count, k.vv);
    fill_mixed(m, f, t.cu, t.count, k.uv);
  }
  add_block<0, 0>(p, k, t.count, t.tangent);
  add_block<1, 0>(p, k, t.count, t.tangent);
  add_block<1, 1>(p, k, t.count, t.tangent);
  add_block<2, 0>(p, k, t.count, t.tangent);
  add_block<2, 1>(p, k, t.count, t.tangent);
  add_block<2, 2>(p, k, t.count, t.tangent);
}

}  // namespace netloft::priour::angle
