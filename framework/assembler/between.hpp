// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <array>
#include <cstddef>
#include <vector>

namespace netloft {

/// The ends of a step whose mean forces are asked for (netloft_motion::solve_between). Positions are over all
/// degrees of freedom [m].
struct StepEnds {
  const double *before = nullptr, *after = nullptr;
  double length = 0;   // h of the step [s]
  double damping = 0;  // χ of (4)
};

/// Mean forces over a step from x₀ to x₁ = x₀ + Δ, x = (x₀ + x₁)/2, of what has an energy E: their work is
/// exactly its fall, at any length of the step and across slack and taut. Of a member with chord w, l = ‖w‖:
///   T̄ = (ψ(l₁) − ψ(l₀))/(l₁ − l₀),  f = T̄ (w₀ + w₁)/(l₀ + l₁)                                       (1)
/// (J. C. Simo and N. Tarnow, "The discrete energy-momentum method", ZAMP 43, 1992), and of any other
/// element, whose motion as a rigid body is taken out of Δ by the projection P,
///   f = ∇E(x) + μ g,  g = P Δ,  μ = (E(x₁) − E(x₀) − ∇E(x)·Δ)/(g·g)                                  (2)
/// (O. Gonzalez, "Exact energy and momentum conserving algorithms for general models in nonlinear
/// elasticity", Comput. Methods Appl. Mech. Engrg. 190, 2000, element by element); P = 1 where it pushes
/// against something outside. Neither (1) nor (2) pushes or turns an element as a whole. Slope of (1) in x₁:
///   ∂f/∂w₁ = T̄' d t₁ᵀ + T̄ (1 − d t₁ᵀ)/(l₀ + l₁),  d = (w₀ + w₁)/(l₀ + l₁),  t₁ = w₁/l₁              (3)
/// and damping of members, after F. Armero and I. Romero, "On the formulation of high-frequency dissipative
/// time-stepping algorithms for nonlinear dynamics", Comput. Methods Appl. Mech. Engrg. 190, 2001, with a
/// memory m of the rate of stretch, so that what is slow is left alone:
///   T̄ ← T̄ + χ/2 k (l₁ − l₀ − h m),  m ← m + ν ((l₁ − l₀)/h − m),  k = (T(l₁) − T(l₀))/(l₁ − l₀)     (4)
/// Where a member is slack at an end of the step, m is zero after it: a stiffness that appears finds nothing
/// remembered, or energy would come out of nothing.
struct MeanTension {
  double T, slope;  // T̄ [N], its derivative with l₁ [N/m]
};
MeanTension mean_tension(const netloft_member& member, double before, double after);
/// k of (4) [N/m], and its derivative with l₁ [N/m²].
struct MeanStiffness {
  double k, slope;
};
MeanStiffness mean_stiffness(const netloft_member& member, double before, double after);

}  // namespace netloft
