// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/integrator.hpp>

namespace netloft::arkode {

/// One step of a diagonally implicit Runge-Kutta method of SUNDIALS' ARKODE 6 (Reynolds et al. 2023, ACM TOMS
/// 49(2), article 19; users' guide, "Butcher table data structure") on F(t, u, v, a) = 0, with y = (u, v) and
/// y' = (v, a). tₙ is the start of the step, h its length, A, b, c are the coefficients of the method. Stage
/// i is at tᵢ = tₙ + cᵢ h; with γ = h A_ii, and k from the earlier stages:
///   yᵢ = k + γ y'ᵢ,  k = yₙ + h Σ_{j<i} A_ij y'ⱼ                            (1)
/// The two parts of (1), for u and for v, give v and a in terms of u, which the solver of the analysis finds:
///   v = (u − k_u)/γ,  a = (v − k_v)/γ,  F(tᵢ, u, v, a) = 0                    (2)
///   y'ᵢ = (yᵢ − k)/γ                                                        (3)
///   yₙ₊₁ = yₙ + h Σ bᵢ y'ᵢ,  error of one step: ‖h Σ (bᵢ − b̂ᵢ) y'ᵢ‖           (4)
/// All methods here are L-stable. Their last stage is the end of the step and gives aₙ₊₁. Their first stage
/// is explicit with y' = (vₙ, aₙ), so that no step computes accelerations from masses.
///   esdirk3   ARK3(2)4L[2]SA, implicit part; Kennedy and Carpenter, Appl. Numer. Math. 44, 2003
///   tr-bdf2   Bank et al., IEEE Trans. Electron Devices 32, 1985; estimate of Hosea and Shampine, Appl.
///             Numer. Math. 20, 1996
///   kvaerno4  4(3) in five stages; Kværnø, BIT 44, 2004
/// With ARKODE's other methods, steps with stiff bars fail or tensions are less accurate: the README has
/// figures.
struct Arkode {
  struct Parameters {
    std::int64_t method = 0;
  };
  static Step step(const Parameters& parameters, Motion& motion);
  static double order(const Parameters& parameters);
  static double stable_step(const Parameters&, double) { return 0; }
};

}  // namespace netloft::arkode
