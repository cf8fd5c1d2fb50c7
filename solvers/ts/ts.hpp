// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/integrator.hpp>

namespace netloft::ts {

/// One step of TSALPHA2 of PETSc's TS (Balay et al., PETSc/TAO Users Manual 3.18, chapter "TS: Scalable ODE
/// and DAE solvers"), the generalized-α method of Chung and Hulbert (J. Appl. Mech. 60, 1993), on F(t, u, v,
/// a) = 0. PETSc's α count from the start of the step: one less those of the paper.
///   α_m = (2 − ρ)/(1 + ρ),  α_f = 1/(1 + ρ),  γ = ½ + α_m − α_f,  β = ¼ (1 + α_m − α_f)²             (1)
///   F(t_α, u_α, v_α, a_α) = 0,  t_α = tₙ + α_f h                                                   (2)
///   u_α = uₙ + α_f (uₙ₊₁ − uₙ),  v_α alike,  a_α = aₙ + α_m (aₙ₊₁ − aₙ)                             (3)
///   uₙ₊₁ = uₙ + h vₙ + h² ((½ − β) aₙ + β aₙ₊₁),  vₙ₊₁ = vₙ + h ((1 − γ) aₙ + γ aₙ₊₁)               (4)
/// PETSc has (1), (3) and (4). The solver of the analysis finds u_α of (2), where by (3) and (4)
///   dv_α/du_α = γ/(β h),  da_α/du_α = α_m/(α_f β h²)                                               (5)
/// Second order, stable for any h. Error of one step: |β − 1/6| h² (aₙ₊₁ − aₙ)                        (6)
///
/// TS computes the aₙ of its first step by itself, from two additional stages, and gives no access to it. To
/// make it use ours, it first takes two steps without evaluating F: one at rest, u = v = a = 0, which has
/// those stages behind it, and from there one to u = β h² aₙ, at whose end by (4) the acceleration is aₙ.
struct Ts {
  struct Parameters {
    double spectral_radius = 0;  // ρ, at infinite frequency
  };
  static Step step(const Parameters& parameters, Motion& motion);
  static double order(const Parameters&) { return 3; }
  static double stable_step(const Parameters&, double) { return 0; }
};

}  // namespace netloft::ts
