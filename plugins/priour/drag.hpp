// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/twines.hpp"

namespace netloft::priour {

/// Force of the water on the netting of a triangle by the law of drag that the part names. A third of the
/// force acts at each corner: the residual is −F/3, and ∂F/∂v_q = −⅓ F_W. Symbols not defined here are those
/// of triangle.hpp; subscripts t, m, W and S of f and F mark derivatives.
///   W = ⅓ Σ (c_p − v_p)          c [m/s] current, v [m/s] velocity, at the corners                   (1)
/// A law of twines gives f(W, t) [N/m]. It acts on the unstretched length of the twines of both directions:
///   F = n l₀ [f(W, Û) + f(W, V̂)],  n = |d|/2                                                         (2)
///   ∂F/∂x_q = n l₀ [a_q f_t(Û)(I − ÛÛᵀ)/‖U‖ + b_q f_t(V̂)(I − V̂V̂ᵀ)/‖V‖] + ⅓ F_W (dc/dz)_q e_zᵀ        (3)
/// A law of screens gives f(W, m, S) [N/m²] for the normal m and the solidity S. It acts on the area A:
///   N = (x₂−x₁)×(x₃−x₁),  A = ½‖N‖,  m = N/‖N‖,  S = |d| D l₀/A  (only the law limits S)           (4)
///   F = A f                                                                                          (5)
///   ∂F/∂N = ½ (f − S f_S) mᵀ + ½ f_m (I − mmᵀ)                                                       (6)
///   ∂F/∂x_q = ∂F/∂N [e_q]× + ⅓ F_W (dc/dz)_q e_zᵀ,  e_q = x_{q+2} − x_{q+1} cyclic                   (7)
/// D [m] is the diameter, l₀ [m] the length of a bar, (dc/dz)_q the vertical gradient of the current at
/// corner q, and [e]× v = e×v. An area below kNoArea |d| l₀² is replaced by that value, because a folded
/// triangle has no normal. Source: the trawl-gear paper, eqs. (2) and (4).
struct Drag {
  static constexpr double kNoArea = 1e-12;

  static Status tile(const Family<Triangle>& family, netloft_tile& t);
  /// Magnitude of F of each triangle [N]; zero in still water.
  static void output(const Family<Triangle>& family, const netloft_tile& t, double* values);
};

/// The drag that netting loses above the surface, by (2) of plugins/common/surface.hpp.
struct DryDrag {
  static Status tile(const Family<Triangle>& family, netloft_tile& t);
};

}  // namespace netloft::priour
