// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <array>

namespace netloft::rope {

/// Resistance of a rope to bending, between two neighbouring bars of unstretched lengths L₁, L₂.
///   w₁ = x₁ − x₀,  w₂ = x₂ − x₁,  t = w/l,  c = t₁·t₂ = cos φ,  φ the turning angle       (1)
///   E = −κ ln((1 + c)/2),  κ = 4 EI/(L₁ + L₂)                                              (2)
///   dE/dφ = EI/R,  R = (L₁ + L₂)/(4 tan(φ/2))                                              (3)
///   ∂c/∂w₁ = (I − t₁t₁ᵀ) t₂/l₁ = g₁,  ∂c/∂w₂ = (I − t₂t₂ᵀ) t₁/l₂ = g₂                      (4)
///   ∂²c/∂w₁∂w₁ = −(t₁g₁ᵀ + g₁t₁ᵀ)/l₁ − c (I − t₁t₁ᵀ)/l₁²                                   (5)
///   ∂²c/∂w₁∂w₂ = (I − t₁t₁ᵀ)(I − t₂t₂ᵀ)/(l₁ l₂)                                            (6)
/// EI [N m²] bending stiffness. R is the radius of the circle that touches both bars at their middles when
/// they are equally long. Expressed in c, nothing is singular in a straight rope; 1 + c is computed from the
/// chord t₂ − t₁, which avoids cancellation there. A rope folded back upon itself (φ → π) or a bar of no
/// length has no curvature: outside the domain. Bars that meet at a joint of ropes do not bend each other.
/// Source: the trawl-gear paper, eq. (1).
struct Bending {
  static constexpr auto stencil = NETLOFT_BAR_PAIR;

  struct Parameters {
    double EI = 0;
  };
  struct Data {
    std::array<double, 2> rest_length{};  // L₁, L₂ [m]
  };

  static double kappa(const Parameters& p, const Data& d) {
    return 4 * p.EI / (d.rest_length[0] + d.rest_length[1]);
  }
  /// φ [rad].
  static double turning_angle(const State<3>& s);

  struct Elastic {
    static Status evaluate(const Parameters& p, const Data& d, const State<3>& s, Local<3>& out);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 3>& x) {
      const Vec3<T> w1 = x[1] - x[0], w2 = x[2] - x[1];
      return -kappa(p, d) * log(0.5 * (1.0 + dot(w1, w2) / (norm(w1) * norm(w2))));
    }
  };
};

}  // namespace netloft::rope
