// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/step_tile.hpp"

namespace netloft {

// Mean forces of elements with an energy E, over a step from x₀ to x₁ = x₀ + Δ whose middle is x = (x₀ +
// x₁)/2:
//   f = ∇E(x) + μ g,  g = P Δ,  μ = (E(x₁) − E(x₀) − ∇E(x)·Δ)/(g·g)                                  (1)
//   ∂f/∂x = K + g ⊗ [(2 ∇E(x₁) − 2 ∇E(x) − K Δ)/(g·g) − 4 μ g/(g·g)] + 2 μ P,  K = ∇∇E(x)            (2)
// P removes the rigid-body motion of the element from Δ, so that the correction has no resultant force and no
// resultant moment; P = 1 if the element pushes against something outside. The work of f is exactly the
// decrease of the energy. (2) leaves out the change of P with x and replaces the last P by 1. O. Gonzalez,
// "Exact energy and momentum conserving algorithms for general models in nonlinear elasticity", Comput.
// Methods Appl. Mech. Engrg. 190, 2000; applied here to each element.

/// Adds the force μ g of (1), and the tangent (2) without K, for one term on all elements of a tile. Returns
/// the first status other than NETLOFT_OK.
int add_mean_of_energy(const TileOfStep& of, const netloft_term& term);

}  // namespace netloft
