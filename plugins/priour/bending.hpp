// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <array>

namespace netloft::priour {

/// Resistance of netting to bending across the edge (a, b) that the triangles (a, b, c) and (b, a, d) share.
///   e₀ = x_b − x_a, e₁ = x_c − x_a, e₂ = x_d − x_a;  N₁ = e₀×e₁, N₂ = e₂×e₀                          (1)
///   c = N̂₁·N̂₂ = cos φ, φ the turning angle, 0 where the netting is flat                              (2)
///   E = −κ ln((1 + c)/2),  κ = 4 k b/(h₁ + h₂)                                                       (3)
///   dE/dφ = k b/R,  R = (h₁ + h₂)/(4 tan(φ/2))                                                       (4)
/// The unstretched altitudes h₁, h₂ over the edge play the part of two bars of a rope. b is the unstretched
/// edge, k [N m] the bending stiffness of a metre of it: over both directions of twines, EI × twines that
/// cross a metre × cos² of the angle between twine and the normal of the edge in the netting.
/// A diamond mesh has no unstretched shape of its own. Lengths are those of meshes of half angle β, 45°
/// unless the part says otherwise; with (Δu, Δv) along the edge and d_i of triangle (1) of both sides:
///   b_i = l₀ √(Δu² + Δv² + 2 Δu Δv cos 2β),  h_i = |d_i| l₀² sin 2β/b_i                              (5)
///   k b = EI (|Δu|³ + |Δv|³) sin² 2β (l₀/b)²                                                         (6)
/// EI [N m²] of one twine, l₀ [m] bar, b the mean of both sides. For the edge along v of meshes at 45° (6) is
/// EI times the number of u twines that cross it. (3) differentiated as in angle (2), (4), (5) with N₁, N₂
/// for U, V, then after e; N is linear in each of two e, whence the terms in ∂E/∂N × e. Outside the domain: a
/// triangle without area, netting folded back upon itself (φ → π). Source: the trawl-gear paper, eq. (1) and
/// fig. 5b.
struct Bending {
  static constexpr auto stencil = NETLOFT_TRIANGLE_PAIR;

  struct Parameters {
    double EI = 0, half_angle = 0;  // half_angle: β [rad]
  };
  struct Data {
    std::array<double, 4> u{}, v{};      // twine coordinates of a, b, c, d [bars]
    std::array<double, 2> bar_length{};  // l₀ of both triangles [m]
  };

  /// (3), (5), (6) [N m].
  static double kappa(const Parameters& p, const Data& d);
  /// φ [rad].
  static double turning_angle(const State<4>& s);
  static void check(const Parameters& p, const Data& d);

  struct Elastic {
    static Status evaluate(const Parameters& p, const Data& d, const State<4>& s, Local<4>& out);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 4>& x) {
      const Vec3<T> e = x[1] - x[0], N1 = cross(e, x[2] - x[0]), N2 = cross(x[3] - x[0], e);
      return -kappa(p, d) * log(0.5 * (1.0 + dot(N1, N2) / (norm(N1) * norm(N2))));
    }
  };
};

}  // namespace netloft::priour
