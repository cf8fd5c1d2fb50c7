// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/march_settings.hpp"
#include "framework/motion/march_state.hpp"
#include "framework/motion/step_scheme.hpp"
#include "framework/motion/transient_problem.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft {

/// Tests whether an integrator follows the equation of motion F(t, u, v, a) = 0. The host takes steps of
/// length h from a state, computes the forces that remain unbalanced, and discards the steps. Every
/// convergent scheme has
///   F(t, u, v, (v_new − v)/h) → 0  and  (u_new − u)·v → h v·v                                (1)
/// for h → 0, even if some modes are faster than any step of the march. Steps are shortened tenfold until the
/// remaining forces are at most half of F(t, u, v, 0) and the second half of (1) holds within a half. If no
/// step satisfies this, the scheme does not integrate this motion; it may do nothing at all. A half is far
/// above the errors by rounding and by the solver's tolerance, and far below the error of a scheme that does
/// nothing. Unknowns without mass are left out.
class SchemeProbe {
 public:
  SchemeProbe(Assembler& assembler, double mass_damping, SolverChoice solver, const MakeFactorisation& make,
              const Limits& limits);

  /// Tests the scheme at a state, beginning with steps of a tenth of its h. Returns a sentence about the
  /// fault. The sentence is empty if (1) holds, if no step could be taken, or if (1) cannot be tested because
  /// forces nearly balance and nothing moves.
  std::string fault_of(const StepScheme& scheme, const MarchState& at);

 private:
  bool find_forces(const MarchState& at);
  bool takes_step(const StepScheme& scheme, const MarchState& at, double h);
  double largest_force(const MarchState& at, std::span<const double> a);
  double left_over(const MarchState& at, double h);
  double moved(const MarchState& at, double h) const;

  TransientProblem problem_;
  std::vector<double> mass_;  // of every unknown, without coupling [kg]
  std::vector<double> a_;     // accelerations from which the scheme starts
  std::vector<double> force_, mean_a_, next_u_, next_v_, next_a_, error_;
  double driving_ = 0;  // largest of the forces F(t, u, v, 0) on unknowns with mass [N]
  bool is_driven_ = false, is_moving_ = false;  // which halves of (1) can be tested
};

}  // namespace netloft
