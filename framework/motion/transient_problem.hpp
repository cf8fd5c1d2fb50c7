// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/moving_state.hpp"
#include "framework/balance/static_problem.hpp"
#include "framework/motion/highest_frequency.hpp"
#include "framework/motion/node_masses.hpp"
#include "framework/registry/descriptors.hpp"

#include <deque>

namespace netloft {

/// The problem F(t, u, v, a) = 0 of a moving scene, with the C interface that an integrator calls. Counts and
/// times every call. The assembler evaluates residuals and masses; the chosen solver solves the algebraic
/// problems of steps.
class TransientProblem {
 public:
  /// `limits` apply to the solution of one step, with the tolerance of its solver.
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
  /// The reason why the last step that failed could not be solved; empty if no step failed.
  const std::string& trouble() const { return trouble_; }

  /// Accelerations at a state; zero for nodes without mass. Returns OK, OUTSIDE_DOMAIN or ERROR.
  int start(double t, std::span<const double> u, std::span<const double> v, std::span<double> a);
  /// Masses of the unknowns at the last state for which accelerations were found, without their coupling
  /// [kg].
  std::vector<double> masses() const { return masses_.diagonal(); }
  /// Balance of the forces in the last evaluation; after start(), the balance without inertia.
  Balance balance() { return algebra_.balance(state_.x(), residual_); }
  /// Highest angular frequency of the linear stiffness and the masses at the start [rad/s].
  double highest_frequency();
  /// Highest angular frequency of the tangent at rest at displacements u [rad/s]; other states may have
  /// higher ones. The iteration starts from the mode of highest_frequency(), so that the result does not
  /// depend on the past of the march; highest_frequency() must have been called before. Zero if an element
  /// failed.
  double highest_frequency_at(std::span<const double> u);
  /// The reason for which explicit schemes cannot be used; empty if they can.
  std::string obstacle_to_explicit(const Scene& scene);
  /// Raises the load to which tolerances are relative [N] to the largest load in `residual` (over all dofs).
  /// A larger load stays unchanged.
  void note_loads(std::span<const double> residual);
  /// The midpoint of the last step, which ends at displacements u and is not accepted yet; nullptr if the
  /// step did not use mean forces, or if an element failed (Assembler::fault).
  const MeanStep* mean_step(std::span<const double> u);
  bool is_between() const { return is_between_; }
  /// The forces that determined the last step, over all dofs [N]: means over the step, or forces at its end
  /// (t, u, v, a). Returns false if an element failed, see Assembler::fault.
  bool find_step_forces(double t, std::span<const double> u, std::span<const double> v,
                        std::span<const double> a, std::span<double> residual);
  /// Accepts a step that ends at displacements u. If forces were means over the step, members store their
  /// stretch rates. Returns false if an element fails to report its members.
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
  double memory_ = 0;        // argument `memory` of the attempted step (netloft_motion::solve_between)
  bool is_between_ = false;  // whether the step uses mean forces
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
