// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/step_tile.hpp"

namespace netloft {

// Mean forces of members over a step from x₀ to x₁. A member has the chord w of length l = ‖w‖. T̄ and k are
// its mean tension and stiffness (mean_tension.hpp):
//   f = T̄ d,  d = (w₀ + w₁)/(l₀ + l₁)                                                              (1)
//   ∂f/∂w₁ = T̄' d t₁ᵀ + T̄ (1 − d t₁ᵀ)/(l₀ + l₁),  t₁ = w₁/l₁                                      (2)
// The work of f is exactly the decrease of the energy, for any step length h, and also if the member becomes
// slack or taut. The forces on an element have no resultant force and no resultant moment. Damping, with the
// factor χ, acts on the difference between the rate of stretch and its remembered value m. Slow motion is not
// damped, because m follows the rate by the fraction ν per step:
//   T̄ ← T̄ + χ/2 k (s − h m),  m ← m + ν (s/h − m),  s = l₁ − l₀                                    (3)
// If a member is slack at an end of the step, m is zero afterwards: a remembered rate would add energy when
// the member becomes taut. If the rest length changes from L₀ to L₁, T̄ is the mean (4) over the strain, and
// (5) is exactly the change of the energy ψ. Here, λ = l/L and ψ = L φ(λ), and bars denote means, such as L̄
// = ½ (L₀ + L₁):
//   T̄ = (φ(λ₁) − φ(λ₀))/(λ₁ − λ₀),  s = L̄ (λ₁ − λ₀)                                              (4)
//   ψ(l₁, L₁) − ψ(l₀, L₀) = T̄ (l₁ − l₀) + (φ̄ − T̄ λ̄)(L₁ − L₀)                                     (5)
// The second part of (5) is the work of the winch. Sources: J. C. Simo and N. Tarnow, "The discrete
// energy-momentum method", ZAMP 43, 1992, for (1); F. Armero and I. Romero, "On the formulation of
// high-frequency dissipative time-stepping algorithms for nonlinear dynamics", Comput. Methods Appl. Mech.
// Engrg. 190, 2001, for damping, there without a memory.

/// Replaces the forces and tangents at the middle of the step by (1) and (2), for all members of a tile: adds
/// the differences. `stretch_rates` holds m, [member][64] [m/s]. Returns NETLOFT_OK, or NETLOFT_ERROR if the
/// element fails to write its members.
int add_mean_of_members(const TileOfStep& of, const double* stretch_rates);

/// Updates m of (3) after an accepted step that ends at `time` [s], with ν = `memory`. `step` has the
/// positions at the ends. Returns false if the element fails to write its members.
bool remember_stretch_rates(const ElementFamily& family, std::size_t tile, const StepEnds& ends,
                            double memory, double time, StepTile& step, double* stretch_rates);

}  // namespace netloft
