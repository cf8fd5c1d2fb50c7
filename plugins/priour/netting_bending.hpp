// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <array>

namespace netloft::priour {

/// Resistance of netting to bending across the common edge (a, b) of the triangles (a, b, c) and (b, a, d).
///   e₀ = x_b − x_a, e₁ = x_c − x_a, e₂ = x_d − x_a;  N₁ = e₀×e₁, N₂ = e₂×e₀        edges, normals    (1)
///   n_i = N_i/s_i,  s_i = √(‖N_i‖² + (δ M_i)²)          δ = kClosed, M_i the unstretched ‖N_i‖       (2)
///   E = −κ L(w),  w = 1 − ¼‖n₁ − n₂‖²,  L = ln w,  κ = 4 k b/(h₁ + h₂)                energy [J]     (3)
///   dE/dφ = k b/R,  R = (h₁ + h₂)/(4 tan(φ/2))          φ the turning angle, 0 in flat netting       (4)
/// With δ = 0, n_i would be the unit normal and w = (1 + cos φ)/2. When meshes close, however, normals can
/// turn although the netting does not bend; therefore n_i becomes small below 1/1000 of the unstretched area.
/// This changes E by 1e-6 in open meshes, and by 1 % in meshes with 1/100 of the unstretched area. If netting
/// is drawn together in a plane, triangles can turn over: φ changes from 0 to π, where ln w is infinite.
/// Therefore, below w₀ = kFolded (φ above 176.4°), L is the Taylor polynomial ln w₀ + z − z²/2 with z = w/w₀
/// − 1 (5).
///
/// b [m] is the unstretched length of the edge; h₁, h₂ [m] are the unstretched heights of the triangles over
/// the edge, which correspond to the two bars in the bending of a rope. k [N m] is the bending stiffness per
/// metre of edge: the sum over both directions of twines of EI × twines per metre × cos² of the angle between
/// twine and normal of the edge. EI [N m²] belongs to one twine. A diamond mesh has no unstretched shape;
/// lengths are therefore those of meshes of half angle β, 45° by default. The edge has the twine coordinates
/// (Δu, Δv) [bars]; triangle i has the bar length l₀ [m] and the determinant d_i of triangle.hpp (1):
///   b_i = l₀ √(Δu² + Δv² + 2 Δu Δv cos 2β),  M_i = |d_i| l₀² sin 2β,  h_i = M_i/b_i                  (6)
///   k b = EI (|Δu|³ + |Δv|³) sin² 2β (l₀/b)²                                                         (7)
/// For an edge along v in meshes at 45°, (7) is EI times the number of u twines that cross the edge.
///
/// With D₁ = κ dL/dw, D₂ = −κ d²L/dw², q = n₁ − n₂, σ = (1, −1), A_i = (I − n_i n_iᵀ)/s_i, g_i = ½ D₁ σ_i q:
///   G_i = ∂E/∂N_i = A_i g_i                                                                          (8)
///   ∂²E/∂N_i∂N_j = σ_i σ_j A_i (½ D₁ I + ¼ D₂ q qᵀ) A_j,  and if i = j, in addition
///     − [n_i p_iᵀ + p_i n_iᵀ + (g_i·n_i)(I − n_i n_iᵀ)]/s_i²,  p_i = g_i − (g_i·n_i) n_i = s_i G_i   (9)
/// Source: the trawl-gear paper, eq. (1) and fig. 5b; (2) and (5) were derived for this program.
struct Bending {
  static constexpr auto stencil = NETLOFT_TRIANGLE_PAIR;
  static constexpr double kClosed = 1e-3, kFolded = 1e-3;

  struct Parameters {
    double EI = 0, half_angle = 0;  // half_angle: β [rad]
  };
  struct Data {
    std::array<double, 4> u{}, v{};      // twine coordinates of a, b, c, d [bars]
    std::array<double, 2> bar_length{};  // bar lengths l₀ of both triangles [m]
  };

  /// The numbers of a pair of triangles that do not change with its shape: κ [N m] of (3) and M [m²] of (6).
  struct Flat {
    double kappa, M[2];
  };
  static Flat flat(const Parameters& p, const Data& d);
  static double turning_angle(const State<4>& s);
  static void check(const Parameters& p, const Data& d);

  struct Elastic {
    static Status evaluate(const Parameters& p, const Data& d, const State<4>& s, Local<4>& out);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 4>& x) {
      const Flat flat = Bending::flat(p, d);
      const Vec3<T> e = x[1] - x[0], N[2] = {cross(e, x[2] - x[0]), cross(x[3] - x[0], e)};
      Vec3<T> n[2];
      for (int k = 0; k < 2; ++k)
        n[k] = (1.0 / sqrt(dot(N[k], N[k]) + kClosed * kClosed * flat.M[k] * flat.M[k])) * N[k];
      const T w = 1.0 - 0.25 * dot(n[0] - n[1], n[0] - n[1]), z = w / T(kFolded) - 1.0;
      return -flat.kappa * (w < T(kFolded) ? std::log(kFolded) + z - 0.5 * z * z : log(w));
    }
  };
};

}  // namespace netloft::priour
