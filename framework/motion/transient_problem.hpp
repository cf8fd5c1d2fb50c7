// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/moving_state.hpp"
#include "framework/balance/static_problem.hpp"
#include "framework/motion/highest_frequency.hpp"
#include "framework/motion/node_masses.hpp"
#include "framework/registry/descriptors.hpp"

#include <deque>

namespace netloft {

/// F(t, u, v, a) = 0 of a scene that moves: what an integrator sees, with the host's statistics behind it.
/// Residuals and masses come from the assembler; algebraic problems of steps go to whichever solver was
/// chosen.
class TransientProblem {
 public:
  /// `limits` are those of one step's problem, and its solver's tolerance.
  TransientProblem(Assembler& assembler, double mass_damping, SolverChoice solver,
                   const MakeFactorisation& make, Limits limits);

  netloft_motion& interface() { return interface_; }
  std::size_t size() const { return static_cast<std::size_t>(assembler_.pattern().size); }
  MovingState& state() { return state_; }
  StaticProblem& algebra() { return algebra_; }
  const StaticProblem& algebra() const { return algebra_; }
  Statistics statistics() const;
  const char* message() const { return message_; }
  void keep_message(const char* text);
  /// Why the last step's problem was not solved, if it was not.
  const std::string& trouble() const { return trouble_; }

  /// Accelerations at a state; nodes without mass get none. OK, OUTSIDE_DOMAIN or ERROR.
  int start(double t, std::span<const double> u, std::span<const double> v, std::span<double> a);
  /// Of the forces in the last evaluation, that of `start` without inertia.
  Balance balance() { return algebra_.balance(state_.x(), residual_); }
  /// Highest angular frequency that the linear stiffness and the masses at the start allow [rad/s].
  double highest_frequency();
  /// The same of the tangent where it rests at displacements u, which need not bound other states. Begins at
  /// the mode that highest_frequency() has found, which has to be called before; so it is the same whenever a
  /// march gets here.
  double highest_frequency_at(std::span<const double> u);
  /// What makes explicit schemes impossible here; empty: nothing.
  std::string obstacle_to_explicit(const Scene& scene);
  /// Raises what tolerances are a part of to the loads in `residual`, over all dofs [N].
  void note_loads(std::span<const double> residual);
  /// Of the step that ends at displacements u, before it is accepted, if its forces were means; null if not,
  /// and if there are no forces: see the assembler's fault().
  const MeanStep* mean_step(std::span<const double> u);
  /// Whether the forces of the last step were means.
  bool is_between() const { return is_between_; }
  /// The forces that the last step was made with, over all dofs [N]: their means over it, or those at its end
  /// (t, u, v, a). False: see the assembler's fault().
  bool find_step_forces(double t, std::span<const double> u, std::span<const double> v,
                        std::span<const double> a, std::span<double> residual);
  /// A step that ends at displacements u is accepted: members remember it if its forces were means. False:
  /// an element does not tell its members.
  bool accept(std::span<const double> u);
  double least_load() const { return least_load_; }
  void set_least_load(double load) { least_load_ = load; }

 private:
  int residual(double t, const double* u, const double* v, const double* a, double* r);
  int accelerate(double t, const double* u, const double* v, double* a);
  int solve(double t, const double* v0, double cv, const double* a0, double ca, double* u);
  int solve_between(const double* v0, double cv, const double* a0, double ca, double damping, double memory,
                    double* u);
  int solve_step(const StepProblem& step, double* u);
  void place_end(std::span<const double> u);
  bool find_mean_forces(std::span<const double> u, std::span<double> residual);
  int accelerate_at(double t, std::span<const double> u, std::span<const double> v, std::span<double> a,
                    bool massless_rest);
  int evaluate();
  Pencil pencil(Pencil::Apply stiffness) const;

  Assembler& assembler_;
  MovingState state_;
  SolverChoice solver_;
  StaticProblem algebra_;
  StepProblem::Ends ends_;
  double memory_ = 0;        // of members, asked for with the step that is tried
  bool is_between_ = false;  // its forces are means
  MeanStep mean_;
  NodeMasses masses_;
  netloft_motion interface_{};
  Statistics statistics_;
  double least_load_ = 0;
  std::vector<double> stiffest_;  // shape of the mode of highest_frequency()
  std::string trouble_;
  char message_[256] = "";
  std::vector<double> zero_, residual_, mass_;
  std::deque<std::vector<double>> scratch_;
};

}  // namespace netloft
