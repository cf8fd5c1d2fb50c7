// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

namespace netloft::rope {

/// Two neighbouring bars w₁, w₂ of lengths l₁, l₂, and the derivatives that an energy E(c) of the cosine c of
/// the angle between them needs:
///   w₁ = x₁ − x₀,  w₂ = x₂ − x₁,  t = w/l,  c = t₁·t₂ = cos φ,  φ the turning angle       (1)
///   ∂c/∂w₁ = (I − t₁t₁ᵀ) t₂/l₁ = g₁,  ∂c/∂w₂ = (I − t₂t₂ᵀ) t₁/l₂ = g₂                      (2)
///   ∂²c/∂w₁∂w₁ = −(t₁g₁ᵀ + g₁t₁ᵀ)/l₁ − c (I − t₁t₁ᵀ)/l₁²                                   (3)
///   ∂²c/∂w₁∂w₂ = (I − t₁t₁ᵀ)(I − t₂t₂ᵀ)/(l₁ l₂)                                            (4)
/// 1 − c is computed from the chord t₂ − t₁, which avoids cancellation in a straight rope.
struct Turn {
  static constexpr double kShortest = 1e-9;  // fraction of its rest length below which a bar has no direction

  explicit Turn(const State<3>& s) {
    const Vec3<double> w[2] = {s.between(0, 1), s.between(1, 2)};
    for (int k = 0; k < 2; ++k) {
      l[k] = norm(w[k]);
      t[k] = (1 / l[k]) * w[k];
    }
    const Vec3<double> d = t[1] - t[0];
    h = 0.25 * dot(d, d);
    c = 1 - 2 * h;
    g[0] = (1 / l[0]) * (d - dot(t[0], d) * t[0]);
    g[1] = (-1 / l[1]) * (d - dot(t[1], d) * t[1]);
  }
  bool is_inside(const std::array<double, 2>& rest_length) const {
    return l[0] > kShortest * rest_length[0] && l[1] > kShortest * rest_length[1];
  }
  /// Entry (r, s) of ∂²c/∂w_a∂w_b, by (3) if a = b, else by (4).
  double second(int a, int b, int r, int s) const {
    const auto across = [this](int k, int i, int j) { return (i == j ? 1 : 0) - t[k][i] * t[k][j]; };
    if (a == b) return -(t[a][r] * g[a][s] + g[a][r] * t[a][s]) / l[a] - c * across(a, r, s) / (l[a] * l[a]);
    double product = 0;
    for (int k = 0; k < 3; ++k) product += across(a, r, k) * across(b, k, s);
    return product / (l[0] * l[1]);
  }

  double l[2], h = 0, c = 1;  // h = (1 − c)/2
  Vec3<double> t[2], g[2];
};

/// An energy and its derivatives with respect to c [J].
struct OfCosine {
  double E, E1, E2;
};

/// Fills in energy, force and tangent for an energy f that is a function of c.
inline void add_of_cosine(const Turn& q, const OfCosine& f, const State<3>& s, Local<3>& out) {
  constexpr double chord[2][3] = {{-1, 1, 0}, {0, -1, 1}};  // w_k = Σ chord[k][p] x_p
  out.energy = f.E;
  for (std::size_t n = 0; n < 3; ++n)
    out.force[n] = (f.E1 * chord[0][n]) * q.g[0] + (f.E1 * chord[1][n]) * q.g[1];
  if (!s.wants_tangent) return;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
          const double H = s.cu * (f.E2 * q.g[a][r] * q.g[b][c] + f.E1 * q.second(a, b, r, c));
          for (int n = 0; n < 3; ++n)
            for (int m = 0; m < 3; ++m) out.tangent[3 * n + r][3 * m + c] += chord[a][n] * chord[b][m] * H;
        }
}

}  // namespace netloft::rope
