// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/twines.hpp"

namespace netloft::priour {

/// An energy E(c) of the angle 2α between the twines of a mesh, as a function of its cosine. It needs no
/// normal of the netting, and a function that is smooth in c is also smooth for closed meshes.
///   c = Û·V̂ = cos 2α,  s = |Û×V̂| = sin 2α                                                      (1)
///   p = V̂ − cÛ,  q = Û − cV̂;  ∂c/∂U = p/‖U‖,  ∂c/∂V = q/‖V‖                                     (2)
///   r_p = E′ (a_p p/‖U‖ + b_p q/‖V‖)                                     residual ∂E/∂x_p         (3)
///   ∂²E/∂U² = [E″ ppᵀ − E′ (pÛᵀ + Ûpᵀ + c (I − ÛÛᵀ))]/‖U‖²               V alike, with q         (4)
///   ∂²E/∂U∂V = [E″ pqᵀ + E′ (I − ÛÛᵀ − V̂V̂ᵀ + c ÛV̂ᵀ)]/(‖U‖‖V‖)                                    (5)
///   K_pq = a_p a_q E_UU + b_p b_q E_VV + a_p b_q E_UV + b_p a_q E_UVᵀ                             (6)
/// U, V, a, b by triangle (1)–(3).
///
/// Convex part, in closed form. Changes of U and V, divided by ‖U‖ and ‖V‖, have the components r along the
/// twine, φ across it in the plane of the twines (positive from Û to V̂) and w along the normal. With h′ =
/// −s E′ and h″ = s²E″ − cE′, the derivatives of E with respect to 2α, the second differential of E is
///   h″(φ_v−φ_u)² + 2h′(r_u φ_u − r_v φ_v)                        in the plane                      (7)
///   −E′ (c w_u² − 2 w_u w_v + c w_v²)                            out of the plane                  (8)
/// (7) is 2h″σ² − 2h′(μσ + κτ) in σ, τ = (φ_v ∓ φ_u)/√2 and μ, κ = (r_v ± r_u)/√2, two 2×2 matrices; (8) is a
/// third, with the eigenvectors (1, ±1)/√2. Each has one eigenvalue ≥ 0; together they make the convex part:
///   h″ + ρ, ρ = √(h″²+h′²), of (σ, μ) ~ (h″+ρ, −h′);  |h′| of (τ, κ) ~ (1, −sgn h′);
///   −E′(1+c) of w_u = −w_v or E′(1−c) of w_u = w_v                                                (9)
/// There is no metric, a constant upper bound of the stiffness, because 1/‖U‖² has no bound.
namespace angle {

/// The twines of every element and the angle between them. Throws OutsideDomain if a twine has no direction.
struct Meshes {
  Meshes(const Triangle::Lanes& lanes, netloft_tile& tile);

  Twines u, v;
  double c[kLanes], s[kLanes];  // (1)
};

/// E and its derivatives with respect to c, of every element [J].
struct Function {
  double E[kLanes], E1[kLanes], E2[kLanes];
};

/// Adds what the tile requests: the energy, the residual (3), and the tangent (6) or its convex part (9).
void add(const Triangle::Lanes& lanes, const Meshes& meshes, const Function& f, netloft_tile& t);

/// cos 2α for dual numbers: the reference implementation for tests of the kernels.
template <class T>
T cosine(const Triangle::Data& d, const Points<T, 3>& x) {
  const auto h = Triangle::shape(d);
  const Vec3<T> U = h.a[0] * x[0] + h.a[1] * x[1] + h.a[2] * x[2];
  const Vec3<T> V = h.b[0] * x[0] + h.b[1] * x[1] + h.b[2] * x[2];
  return dot(U, V) / (norm(U) * norm(V));
}

}  // namespace angle
}  // namespace netloft::priour
