// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/twines.hpp"

namespace netloft::priour {

/// Force of the water on the netting of a triangle, a third per corner, by the law that the part names.
///   W = ⅓ Σ (c_p − v_p)          c [m/s] current, v velocity of the corners                          (1)
/// With a law of twines f(W, t) [N/m], for the unstretched length of the twines of both directions:
///   F = n l₀ [f(W, Û) + f(W, V̂)],  n = |d|/2                                                         (2)
///   ∂F/∂x_q = n l₀ [a_q f_t(Û)(I − ÛÛᵀ)/‖U‖ + b_q f_t(V̂)(I − V̂V̂ᵀ)/‖V‖] + ⅓ F_W (dc/dz)_q e_zᵀ        (3)
/// With a law of screens f(W, m, S) [N/m²], for the current area of the triangle:
///   N = (x₂−x₁)×(x₃−x₁),  A = ½‖N‖,  m = N/‖N‖,  S = |d| t l₀/A  (only the law limits S)           (4)
///   F = A f                                                                                          (5)
///   ∂F/∂N = ½ (f − S f_S) mᵀ + ½ f_m (I − mmᵀ)                                                       (6)
///   ∂F/∂x_q = ∂F/∂N [e_q]× + ⅓ F_W (dc/dz)_q e_zᵀ,  e_q = x_{q+2} − x_{q+1} cyclic                   (7)
/// Residual −F/3 at every corner; ∂F/∂v_q = −⅓ F_W. t [m] diameter, l₀ [m] bar, f_t, f_m, f_W, f_S
/// derivatives of the law. An area below kNoArea |d| l₀² is replaced by that value, because a folded triangle
/// has no normal. Source: the trawl-gear paper, eqs. (2) and (4).
struct Drag {
  static constexpr double kNoArea = 1e-12;

  static Status tile(const Family<Triangle>& family, netloft_tile& t);
  /// Magnitude of F of each triangle [N]; zero in still water.
  static void output(const Family<Triangle>& family, const netloft_tile& t, double* values);
};

/// The drag that netting loses above the surface, by surface.hpp (2).
struct DryDrag {
  static Status tile(const Family<Triangle>& family, netloft_tile& t);
};

}  // namespace netloft::priour
