// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/configuration.hpp"
#include "framework/balance/factors.hpp"
#include "framework/balance/limits.hpp"
#include "framework/balance/matrices.hpp"
#include "framework/balance/observer.hpp"
#include "framework/balance/scales.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft {

/// Returns NETLOFT_CONSERVATIVE if all forces of the scene are conservative, and NETLOFT_SYMMETRIC if its
/// matrix is symmetric.
std::uint32_t traits_of(const Assembler& assembler);

struct SolverChoice {
  const SolverType* type = nullptr;
  const void* parameters = nullptr;
};

/// Calls the solver. During the call, the solver's plugin is recorded as running (plugin_call.hpp), so that
/// the message about a crash can name it. Throws std::runtime_error if the plugin breaks a rule of the plugin
/// interface.
netloft_outcome call_solver(SolverChoice solver, netloft_problem& problem);

/// How well forces are in balance at a point. Loads are the dead loads on nodes and the reactions of held
/// nodes.
struct Balance {
  double residual = 0;        // largest nodal residual [N]
  double scale = 0;           // largest nodal load [N]
  std::uint32_t worst = 0;    // node of the largest residual
  double floor = 0;           // upper bound of the residual that rounding of the positions causes [N]
  bool balanced = false;      // whether the forces are in balance, by the rules in convergence.hpp
  bool at_round_off = false;  // balanced at round-off, but not within the tolerance

  Convergence convergence() const {
    if (!balanced) return Convergence::none;
    return at_round_off ? Convergence::at_round_off : Convergence::within_tolerance;
  }
};

/// Length of a solver's path: the sum over all accepted steps of the largest nodal displacement in the step.
class PathLength {
 public:
  double up_to(std::span<const double> u);

 private:
  std::vector<double> last_;  // u of the previous point
  double sum_ = 0;            // [m]
};

/// The problem r(u) = 0 of a static scene or of a step in time, with the C interface that a solver calls.
/// Counts and times every call, and decides on convergence.
class StaticProblem {
 public:
  StaticProblem(Assembler& assembler, MakeFactorisation make, Limits limits, Observer observer = {});

  netloft_problem& interface() { return interface_; }
  const Statistics& statistics() const { return statistics_; }
  const std::vector<IterationRecord>& history() const { return history_; }
  Stop stop() const { return stop_; }
  const char* solver_message() const { return message_; }
  /// Whether forces overflowed in the last evaluation.
  bool met_bad_numbers() const { return bad_numbers_; }
  /// Whether the last evaluation ended with an error of an element; Assembler::fault describes it.
  bool met_error() const { return met_error_; }
  void keep_message(const char* text);
  std::string factorisation_name() const { return factors_.description(); }
  const FactorResult& last_factor() const { return factors_.last_result(); }

  /// Recomputes positions and residual over all dofs and the energy at displacements u. Returns false if
  /// numbers were not finite or an element failed, which Assembler::fault describes.
  bool recompute(std::span<const double> u, std::vector<double>& x, std::vector<double>& residual,
                 double& energy);
  Balance balance(std::span<const double> x, std::span<const double> residual);
  /// Converts a balance to the quantities from which convergence.hpp decides.
  Imbalance imbalance_of(const Balance& b);
  Scales& scales() { return scales_; }
  const Scales& scales() const { return scales_; }
  /// Begins a step in time: from now on, its equations are the problem to be solved.
  void begin(const StepProblem& step);
  /// Makes displacements u relative to the positions `base`, which are near the solution (see Configuration).
  void count_from(std::vector<double> base);
  /// Positions of all dofs at displacements u [m].
  const std::vector<double>& positions(std::span<const double> u);
  /// Digits that rounding removes from the positions of the last evaluation [m]; empty if displacements are
  /// relative to the start.
  const std::vector<double>& x_low() const { return configuration_.x_low(); }
  void forget_factor() { factors_.forget(); }
  /// The factorisations of this problem, which can also factorise other matrices of the same pattern.
  Factors& factors() { return factors_; }
  Matrices& matrices() { return matrices_; }
  bool conservative() const { return interface_.traits & NETLOFT_CONSERVATIVE; }
  /// Discards the linear stiffness, because the properties of elements have changed.
  void forget_metric() { matrices_.forget_metric(); }
  /// Factorises the exact tangent at u plus `shift` times the metric.
  netloft_factor factorise_at(std::span<const double> u, double shift);

 private:
  int evaluate(std::uint32_t want, const double* u, double* energy, double* residual);
  int evaluate_both(const double* u, double* energy, double* residual, double* gradient);
  int factorise(int matrix, double shift);
  int factorise_between(double blend, double shift);
  int solve(const double* rhs, double* x);
  int multiply(int matrix, double shift, const double* x, double* y);
  int row_sums(int matrix, double shift, double* y);
  int progress(const double* u, double energy, const double* residual, const char* note);
  double step_length(const double* du) const;

  std::size_t size() const { return u_.size(); }
  Request begin_evaluation(const double* u, double* energy);
  int find_forces(const Request& request, const double* u, double* residual, double* gradient = nullptr);
  netloft_factor factorise_sum(std::span<const double> sum, bool may_be_indefinite);
  void find_reactions(const double* u, const double* residual);
  void keep_record(const Balance& b, double energy, const char* note);
  Stop stop_at(std::span<const double> u, bool has_arrived);
  bool does_not_settle(std::span<const double> u);
  bool has_run_away(std::span<const double> x) const;
  double rounding_at(std::int32_t unknown, std::span<const double> x) const;

  Assembler& assembler_;
  Limits limits_;
  Observer observer_;
  netloft_problem interface_{};
  Statistics statistics_;
  Scales scales_;
  Configuration configuration_;
  Matrices matrices_;
  Factors factors_;
  std::vector<IterationRecord> history_;
  Stop stop_ = Stop::none;
  int iterations_before_ = 0;  // iterations of previous steps
  PathLength path_;
  bool bad_numbers_ = false, met_error_ = false;
  double begun_ = 0, begun_cpu_ = 0;  // [s]
  char message_[256] = "";
  std::vector<double> u_, residual_, gradient_;
  std::vector<double> reactions_of_;  // u at which residual_ holds the reactions; empty: it holds none
};

}  // namespace netloft
