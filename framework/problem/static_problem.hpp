// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/problem/convergence.hpp"
#include "framework/problem/moving_state.hpp"
#include "framework/problem/statistics.hpp"
#include "framework/problem/work.hpp"

#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <optional>

namespace netloft {

/// NETLOFT_CONSERVATIVE and NETLOFT_SYMMETRIC, where all forces of a scene are.
std::uint32_t traits_of(const Assembler& assembler);

/// Lets `solver` work on a problem, and says on whose account as long as it does (plugin_call.hpp).
netloft_outcome call_solver(const SolverType& solver, const void* parameters, netloft_problem& problem);

/// The accepted point of the scene itself that came closest to balance so far, for whoever has to end a
/// solver that does not come back.
struct KeptPoint {
  std::vector<double> u;           // displacements of the unknowns [m]; empty: there was none
  double residual = 0, scale = 0;  // [N]
  void keep(std::span<const double> at, double at_residual, double at_scale) {
    if (!u.empty() && !(at_residual * scale < residual * at_scale)) return;
    u.assign(at.begin(), at.end()), residual = at_residual, scale = at_scale;
  }
};

struct JudgedPoint;  // assessment.hpp

/// When to stop.
struct Limits {
  double tolerance = kTolerance;  // largest nodal residual over the largest nodal load
  int iterations = 1000;
  double seconds = std::numeric_limits<double>::infinity();  // of the processor that the user allows
  const std::atomic<bool>* interrupt = nullptr;
  KeptPoint* kept = nullptr;      // where points of the scene itself are kept; null: nowhere
  bool ask_growth = true;         // whether a small disturbance grows, where forces have no energy
  JudgedPoint* judged = nullptr;  // the equilibrium whose stability was decided last; null: not kept
  bool accept_swinging = false;   // whether an equilibrium about which something swings is an answer
  // that its nodes may go in all steps together, over the gear's size: what goes farther has no rest
  double path = std::numeric_limits<double>::infinity();
  const WorkModel* model = nullptr;                       // null: work is not limited
  double work = std::numeric_limits<double>::infinity();  // budget, in units of the model
};

/// How far a residual is from balance, by node. Loads are the dead loads on nodes and the reactions of held
/// ones.
struct Balance {
  double residual = 0;        // largest nodal residual [N]
  double scale = 0;           // largest nodal load [N]
  std::uint32_t worst = 0;    // node of the largest residual
  double floor = 0;           // what rounding of the positions is worth [N]
  bool balanced = false;      // by convergence.hpp
  bool at_round_off = false;  // but not within the tolerance

  Convergence convergence() const {
    if (!balanced) return Convergence::none;
    return at_round_off ? Convergence::at_round_off : Convergence::within_tolerance;
  }
};

/// A step in time as a problem in u: rates follow u, everything else is known.
///   F(t, u, v₀ + cv u, a₀ + ca u) = 0                                            (1)
struct StepProblem {
  double t;
  std::span<const double> v0, a0;
  double cv, ca;
  std::span<const double> mass;  // of each unknown [kg]: ca times it is a stiffness that rounding meets
  MovingState* state;            // where positions and rates of the moment are kept
  double least_load;             // [N] that tolerances are a part of, at the least
  /// The step whose mean forces F has (netloft_motion::solve_between): u is then its middle, and `after` is
  /// kept up with it. Null: forces at u.
  struct Ends {
    StepEnds ends;
    double begin = 0, end = 0;                 // [s]
    std::vector<double> u, x_before, x_after;  // at the beginning; over all dofs
  };
  Ends* between = nullptr;
};

/// r(u) = 0 of a static scene, or of a step in time: what a solver sees, with the host's statistics behind
/// it. Counts and times every call, decides on convergence, keeps matrices and factors.
class StaticProblem {
 public:
  enum class Stop { none, arrived, iterations, time, work, interrupted, ran_away, unsettled };

  StaticProblem(Assembler& assembler, MakeFactorisation make, Limits limits,
                std::function<void(const IterationRecord&)> on_iteration = {});

  netloft_problem& interface() { return interface_; }
  const Statistics& statistics() const { return statistics_; }
  const std::vector<IterationRecord>& history() const { return history_; }
  Stop stop() const { return stop_; }
  const char* solver_message() const { return message_; }
  /// Whether forces overflowed in the last evaluation.
  bool met_bad_numbers() const { return bad_numbers_; }
  /// The last evaluation ended with an element's error, which the assembler's fault tells.
  bool met_error() const { return met_error_; }
  void keep_message(const char* text);
  std::string factorisation_name() const;
  const FactorResult& last_factor() const { return factor_result_; }

  /// Residual over all dofs and energy at displacements u, computed anew. False: it met bad numbers, or see
  /// the assembler's fault.
  bool recompute(std::span<const double> u, std::vector<double>& x, std::vector<double>& residual,
                 double& energy);
  Balance balance(std::span<const double> x, std::span<const double> residual);
  /// A balance as convergence.hpp judges it.
  Imbalance imbalance_of(const Balance& b);
  /// Largest nodal sum of the forces that do not depend on the state [N].
  double dead_load() const { return dead_load_; }
  /// Nodal sums of the forces that drive the gear at the start: those that do not depend on the state, and
  /// those without an energy (drag).
  struct DrivingLoad {
    double largest = 0, sum = 0;  // over nodes [N]
  };
  DrivingLoad driving_load();
  /// From now on this step is the problem, until the next.
  void begin(const StepProblem& step);
  /// From now on u counts from positions `base`, where the problem is all but solved: differences of
  /// positions then have the digits that positions round off. Not where bodies carry nodes.
  void count_from(std::vector<double> base);
  /// Over all dofs at u [m].
  const std::vector<double>& positions(std::span<const double> u);
  /// What those of the last evaluation round off [m]; empty where displacements count from the start.
  const std::vector<double>& low_digits() const { return x_low_; }
  /// The next solution starts without a factor, as if nothing had been solved before.
  void forget_factor() { last_ = nullptr; }
  /// Longest extent of an element at the start [m].
  double element_size() const { return element_size_; }
  /// Largest distance between coordinates at the start [m].
  double gear_size() const { return gear_size_; }
  bool conservative() const { return interface_.traits & NETLOFT_CONSERVATIVE; }
  /// The linear stiffness is evaluated anew when it is next needed: what elements are made of has changed.
  void forget_metric() { metric_.clear(); }
  /// The exact tangent at u, factorised with `shift` times the metric.
  netloft_factor factorise_at(std::span<const double> u, double shift);

 private:
  int evaluate(std::uint32_t want, const double* u, double* energy, double* residual);
  int factorise(int matrix, double shift);
  int factorise_between(double share, double shift);
  int solve(const double* rhs, double* x);
  int multiply(int matrix, double shift, const double* x, double* y);
  int row_sums(int matrix, double shift, double* y);
  int progress(const double* u, double energy, const double* residual, const char* note);
  double step_length(const double* du) const;
  void find_reactions(const double* u, const double* residual);
  bool is_driven();
  bool does_not_settle(const double* u);
  bool has_run_away(std::span<const double> x) const;
  double rounding_at(std::int32_t unknown, std::span<const double> x) const;

  void place(const double* u);
  void place_end(const double* u);
  std::vector<double>& values(MatrixKind kind);
  void need_metric();
  std::span<const double> shifted(int matrix, double shift);
  std::span<const double> between(double share, double shift);
  netloft_factor factorise_and_count(MatrixClass kind, std::span<const double> v);
  MatrixClass matrix_class(bool may_be_indefinite) const;
  netloft_factor factorise_as(MatrixClass kind, std::span<const double> values);
  std::vector<double> sum_of_terms(bool (*counts)(std::uint32_t traits));
  void find_dead_loads();
  double largest_extent(std::span<const double> x) const;
  double largest_distance() const;

  Assembler& assembler_;
  MakeFactorisation make_;
  Limits limits_;
  std::function<void(const IterationRecord&)> on_iteration_;
  netloft_problem interface_{};
  Statistics statistics_;
  std::vector<IterationRecord> history_;
  Stop stop_ = Stop::none;
  StepProblem step_{};
  Kinematics motion_;
  std::vector<double> v_, a_;
  int iterations_before_ = 0;  // of steps that are done
  bool bad_numbers_ = false, met_error_ = false;
  double begun_ = 0, begun_cpu_ = 0, dead_load_ = 0, element_size_ = 1, gear_size_ = 1;
  char message_[256] = "";
  std::optional<bool> is_driven_;     // once it was asked for
  std::vector<double> reactions_of_;  // u that the reactions in residual_ are of; empty: of none
  std::vector<double> path_from_;     // u of the last accepted point, if it is asked how far it goes
  double path_ = 0;                   // [m]

  std::vector<double> u_, x_, residual_, gradient_;
  std::vector<double> base_, x_low_;  // empty: u counts from the start
  double base_extent_ = 0;            // of elements there [m]
  std::vector<double> exact_, convex_, metric_, shifted_;
  std::array<std::unique_ptr<Factorisation>, 3> factorisations_;  // by MatrixClass, made when wanted
  Factorisation* last_ = nullptr;
  FactorResult factor_result_;
};

}  // namespace netloft
