// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/solver.hpp>

namespace netloft::relaxation {

/// Dynamic relaxation with kinetic damping: a fictitious motion is brought to rest whenever its kinetic
/// energy T peaks, and ends in balance. It needs only residuals r(u). The time step is 1.
///   m_i = ½ Σ_j |M_ij|                                                                  (1)
///   v ← v − r/m,   u ← u + v;   from rest, v = −½ r/m                                   (2)
///   T = ½ Σ m_i v_i²                                                                    (3)
///   T past its peak: u ← u − q v,   q = (T₀ − T₁)/(2 T₀ − T₁ − T₋₁);   then from rest      (4)
///   λ = (Δr·v)/(v·m v) < 4                                                              (5)
/// T₋₁, T₀, T₁ are the values of T at three successive half steps, and v in (4) is the velocity at T₀: (4)
/// goes to the top of the parabola through the three values. Sources: (2) A. S. Day, "An introduction to
/// dynamic relaxation", The Engineer 219 (1965) 218-221, by central differences; (1), (3), (4) M. R. Barnes,
/// "Form finding and analysis of tension structures by dynamic relaxation", Int. J. Space Structures 14
/// (1999) 89-104, and B. H. V. Topping and P. Iványi, "Computer Aided Design of Cable Membrane Structures",
/// Saxe-Coburg 2007.
///
/// M is the linear stiffness, assembled once. In M, slack netting is as stiff as taut netting; masses in
/// proportion to the actual stiffness would vanish in slack netting. With the masses (1), λ is below 2 for
/// the stiffness M (Gershgorin). If the tangent becomes larger than M (pressure, drag, stiffening springs), λ
/// exceeds the limit of stability (5), and all masses are raised (P. Underwood, "Dynamic relaxation", in
/// Computational Methods for Transient Analysis, 1983).
///
/// A step costs one evaluation. Convergence takes thousands of steps; the option `steps` says how many of
/// them count as one iteration of the host.
struct Relaxation {
  struct Parameters {
    std::int64_t steps = 0;
  };
  static Outcome solve(const Parameters& parameters, Problem& problem);
};

}  // namespace netloft::relaxation
