// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/twines.hpp"

namespace netloft::priour {

/// An energy E(c) [J] that depends only on the angle 2α between the twines of a mesh, through its cosine c.
/// E does not depend on a normal of the netting, and if E is smooth in c, it is smooth for closed meshes,
/// too. U and V [m] are the vectors of one bar in each twine direction, a_p and b_p [1] their derivatives
/// with respect to the position x_p of corner p (triangle.hpp (1)–(3)), Û and V̂ unit vectors; E′ and E″ are
/// derivatives with respect to c.
///   c = Û·V̂ = cos 2α,  s = |Û×V̂| = sin 2α                                                      (1)
///   p = V̂ − cÛ,  q = Û − cV̂;  ∂c/∂U = p/‖U‖,  ∂c/∂V = q/‖V‖                                     (2)
///   r_p = E′ (a_p p/‖U‖ + b_p q/‖V‖)                                     residual ∂E/∂x_p         (3)
///   E_UU = ∂²E/∂U² = [E″ ppᵀ − E′ (pÛᵀ + Ûpᵀ + c (I − ÛÛᵀ))]/‖U‖²        E_VV with V̂, q for Û, p  (4)
///   E_UV = ∂²E/∂U∂V = [E″ pqᵀ + E′ (I − ÛÛᵀ − V̂V̂ᵀ + c ÛV̂ᵀ)]/(‖U‖‖V‖)                             (5)
///   K_pq = a_p a_q E_UU + b_p b_q E_VV + a_p b_q E_UV + b_p a_q E_UVᵀ    tangent ∂²E/∂x_p∂x_q     (6)
///
/// The convex part of the tangent has a closed form. Let the relative changes δU/‖U‖ and δV/‖V‖ have the
/// components r along the twine, φ across the twine in the plane of both twines (positive from Û to V̂) and w
/// along the normal of that plane, with the subscripts u and v. h′ = −s E′ and h″ = s²E″ − cE′ are the
/// derivatives of E with respect to the angle 2α. The second differential of E is the sum of
///   h″(φ_v−φ_u)² + 2h′(r_u φ_u − r_v φ_v)                        in the plane                      (7)
///   −E′ (c w_u² − 2 w_u w_v + c w_v²)                            out of the plane                  (8)
/// With σ, τ = (φ_v ∓ φ_u)/√2 and μ, κ = (r_v ± r_u)/√2, (7) becomes 2h″σ² − 2h′(μσ + κτ): a 2×2 matrix for
/// (σ, μ) and one for (τ, κ). (8) is a third matrix, with the eigenvectors (1, ±1)/√2. Each matrix has one
/// eigenvalue ≥ 0; these eigenvalues and their eigenvectors make the convex part:
///   h″ + ρ of (σ, μ) ∝ (h″+ρ, −h′), ρ = √(h″²+h′²);   |h′| of (τ, κ) ∝ (1, −sgn h′);
///   −E′(1+c) of w_u = −w_v if E′ < 0, else E′(1−c) of w_u = w_v                                     (9)
/// No constant upper bound of the stiffness (a metric) exists, because 1/‖U‖² has no bound.
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
