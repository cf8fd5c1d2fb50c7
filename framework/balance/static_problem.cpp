// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/static_problem.hpp"

#include "framework/registry/host_function.hpp"
#include "framework/registry/plugin_call.hpp"

#include <netloft/imbalance.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace netloft {

namespace {

MatrixKind kind_of(std::uint32_t want) {
  if (want & NETLOFT_WANT_TANGENT) return MatrixKind::exact;
  if (want & NETLOFT_WANT_CONVEX) return MatrixKind::convex;
  return MatrixKind::none;
}

bool all_finite(std::span<const double> v) {
  double sum = 0;
  for (const double a : v) sum += a - a;  // the sum is zero unless a number is infinite or NaN
  return sum == 0;
}

}  // namespace

std::uint32_t traits_of(const Assembler& assembler) {
  bool conservative = true;
  for (const auto& family : assembler.families())
    for (const auto& term : family->active_terms()) conservative &= (term.traits & NETLOFT_CONSERVATIVE) != 0;
  return (conservative ? std::uint32_t{NETLOFT_CONSERVATIVE} : 0) |
         (assembler.pattern().symmetric ? std::uint32_t{NETLOFT_SYMMETRIC} : 0);
}

netloft_outcome call_solver(SolverChoice solver, netloft_problem& problem) {
  netloft_problem seen = problem;
  const int outcome = call_plugin({solver.type->type.c_str(), "solve", nullptr, CallFrame::Kind::method},
                                  int{NETLOFT_SOLVER_ERROR},
                                  [&] { return solver.type->solver.solve(solver.parameters, &seen); });
  if (const std::string broken = take_broken_rule(); !broken.empty()) throw std::runtime_error(broken);
  if (outcome < NETLOFT_STOPPED || outcome > NETLOFT_SOLVER_ERROR)
    throw std::runtime_error(solver.type->type + ", solve returned " + std::to_string(outcome) +
                             ", which is no outcome");
  if (problem.message_size > 0) problem.message[problem.message_size - 1] = 0;
  return static_cast<netloft_outcome>(outcome);
}

double PathLength::up_to(std::span<const double> u) {
  double largest = 0;
  for (std::size_t i = 0; i < last_.size(); ++i) largest = std::max(largest, std::abs(u[i] - last_[i]));
  last_.assign(u.begin(), u.end());
  return sum_ += largest;
}

StaticProblem::StaticProblem(Assembler& assembler, MakeFactorisation make, Limits limits, Observer observer)
    : assembler_(assembler),
      limits_(limits),
      observer_(std::move(observer)),
      scales_(assembler),
      configuration_(assembler),
      matrices_(assembler, statistics_),
      factors_(std::move(make), statistics_),
      begun_(wall_seconds()),
      begun_cpu_(cpu_seconds()),
      u_(static_cast<std::size_t>(assembler.pattern().size), 0.0),
      residual_(assembler.numbering().dofs()) {
  history_.reserve(static_cast<std::size_t>(std::max(0, limits.iterations)) + 2);
  interface_.size = sizeof interface_;
  interface_.unknowns = static_cast<std::uint32_t>(u_.size());
  interface_.host = this;
  interface_.u = u_.data();
  interface_.message = message_;
  interface_.message_size = sizeof message_;
  interface_.traits = traits_of(assembler);
  interface_.evaluate = HostFunction<&StaticProblem::evaluate>::call;
  interface_.evaluate_both = HostFunction<&StaticProblem::evaluate_both>::call;
  interface_.factorise = HostFunction<&StaticProblem::factorise>::call;
  interface_.factorise_between = HostFunction<&StaticProblem::factorise_between>::call;
  interface_.solve = HostFunction<&StaticProblem::solve>::call;
  interface_.multiply = HostFunction<&StaticProblem::multiply>::call;
  interface_.row_sums = HostFunction<&StaticProblem::row_sums>::call;
  interface_.negative_pivots = [](void* host) {
    return static_cast<StaticProblem*>(host)->last_factor().negative_pivots;
  };
  interface_.progress = HostFunction<&StaticProblem::progress>::call;
  interface_.step_length = [](void* host, const double* du) {
    return static_cast<StaticProblem*>(host)->step_length(du);
  };
  // Reserves memory so that no iteration allocates; the system provides the memory only when it is used.
  for (auto* vector : {&reactions_of_, &gradient_}) vector->reserve(residual_.size());
}

void StaticProblem::keep_message(const char* text) { std::snprintf(message_, sizeof message_, "%s", text); }

void StaticProblem::begin(const StepProblem& step) {
  configuration_.begin(step);
  stop_ = Stop::none;
  reactions_of_.clear();
  iterations_before_ = statistics_.iterations;
}

void StaticProblem::count_from(std::vector<double> base) {
  configuration_.count_from(std::move(base));
  reactions_of_.clear();
}

const std::vector<double>& StaticProblem::positions(std::span<const double> u) {
  configuration_.place(u);
  return configuration_.x();
}

int StaticProblem::evaluate(std::uint32_t want, const double* u, double* energy, double* residual) {
  const MatrixKind kind = kind_of(want);
  statistics_.residuals += residual != nullptr;
  statistics_.matrices += kind != MatrixKind::none;
  Timed timed(statistics_.assembly_seconds);
  Request request = begin_evaluation(u, energy);
  request.conservative_only = want & NETLOFT_WANT_GRADIENT;
  if (request.conservative_only && request.between) {
    if (residual) std::fill_n(residual, size(), 0.0);
    return NETLOFT_OK;
  }
  request.matrix = kind;
  request.values = kind == MatrixKind::none ? nullptr : matrices_.slots(kind).data();
  return find_forces(request, u, residual);
}

int StaticProblem::evaluate_both(const double* u, double* energy, double* residual, double* gradient) {
  ++statistics_.residuals;
  Timed timed(statistics_.assembly_seconds);
  const Request request = begin_evaluation(u, energy);
  if (!request.between) return find_forces(request, u, residual, gradient);
  std::fill_n(gradient, size(), 0.0);
  return find_forces(request, u, residual);
}

/// Begins an evaluation at u. The mean forces of a step in time are not the gradient of an energy. The energy
/// of a step is therefore set to zero, and solvers treat its forces as nonconservative.
Request StaticProblem::begin_evaluation(const double* u, double* energy) {
  statistics_.energies += energy != nullptr;
  bad_numbers_ = met_error_ = false;
  configuration_.place({u, size()});
  Request request;
  request.between = configuration_.between();
  request.motion = configuration_.motion();
  request.energy = request.between ? nullptr : energy;
  if (energy && request.between) *energy = 0;
  return request;
}

/// Writes the forces of the unknowns into `residual`. The forces of all degrees of freedom, including the
/// reactions, remain in residual_.
int StaticProblem::find_forces(const Request& asked, const double* u, double* residual, double* gradient) {
  Request request = asked;
  auto& all = request.conservative_only ? gradient_ : residual_;
  all.resize(configuration_.x().size());
  request.residual = residual ? all.data() : nullptr;
  const bool has_reactions = residual && !request.conservative_only;
  if (has_reactions) reactions_of_.clear();  // a failed evaluation leaves incomplete sums
  if (gradient) {
    gradient_.resize(all.size());
    request.gradient = gradient_.data();
  }
  if (!assembler_.evaluate(configuration_.x(), request)) {
    met_error_ = assembler_.fault().status == NETLOFT_ERROR;
    return assembler_.fault().status;
  }
  if (residual) std::copy_n(all.begin(), size(), residual);
  if (gradient) std::copy_n(gradient_.begin(), size(), gradient);
  if (has_reactions) reactions_of_.assign(u, u + size());
  bad_numbers_ = (request.energy && !std::isfinite(*request.energy)) || (residual && !all_finite(all)) ||
                 (gradient && !all_finite(gradient_));
  return bad_numbers_ ? NETLOFT_OUTSIDE_DOMAIN : NETLOFT_OK;
}

int StaticProblem::factorise(int matrix, double shift) {
  return factorise_sum(matrices_.shifted(matrix & ~NETLOFT_INDEFINITE, shift), matrix & NETLOFT_INDEFINITE);
}

int StaticProblem::factorise_between(double blend, double shift) {
  return factorise_sum(matrices_.between(blend, shift), false);
}

netloft_factor StaticProblem::factorise_sum(std::span<const double> sum, bool may_be_indefinite) {
  if (sum.empty() && !u_.empty()) return NETLOFT_FACTOR_FAILED;
  return factors_.factorise(assembler_.pattern(), may_be_indefinite, sum);
}

int StaticProblem::solve(const double* rhs, double* x) {
  return factors_.solve({rhs, size()}, {x, size()}) ? NETLOFT_OK : NETLOFT_ERROR;
}

int StaticProblem::multiply(int matrix, double shift, const double* x, double* y) {
  return matrices_.multiply(matrix, shift, x, y) ? NETLOFT_OK : NETLOFT_ERROR;
}

int StaticProblem::row_sums(int matrix, double shift, double* y) {
  return matrices_.row_sums(matrix, shift, y) ? NETLOFT_OK : NETLOFT_ERROR;
}

/// Computes the reactions at u, unless they are known there. They are needed because tolerances are relative
/// to the largest of dead loads and reactions.
void StaticProblem::find_reactions(const double* u, const double* residual) {
  if (!std::equal(u, u + size(), reactions_of_.begin(), reactions_of_.end())) {
    gradient_.resize(configuration_.x().size());
    evaluate(NETLOFT_WANT_FORCE, u, nullptr, gradient_.data());
  }
  std::copy_n(residual, size(), residual_.begin());
}

int StaticProblem::progress(const double* at, double energy, const double* residual, const char* note) {
  const std::span<const double> u{at, size()};
  find_reactions(at, residual);
  configuration_.place(u);
  const Balance b = balance(configuration_.x(), residual_);
  const bool was_before = !configuration_.is_in_time() && !history_.empty();
  const bool has_arrived =
      was_before ? may_stop(b.convergence(), b.residual, history_.back().residual) : b.balanced;
  keep_record(b, energy, note);
  if (observer_.kept && configuration_.is_from_start()) observer_.kept->keep(u, b.residual, b.scale);
  if (const Stop stop = stop_at(u, has_arrived); stop != Stop::none) stop_ = stop;
  if (stop_ != Stop::none) return stop_ == Stop::arrived ? NETLOFT_ARRIVED : NETLOFT_GIVE_UP;
  ++statistics_.iterations;
  return NETLOFT_GO_ON;
}

void StaticProblem::keep_record(const Balance& b, double energy, const char* note) {
  IterationRecord record{statistics_.iterations,  b.residual, b.scale, energy, statistics_.factorisations,
                         wall_seconds() - begun_, ""};
  std::snprintf(record.note, sizeof record.note, "%s", note ? note : "");
  if (history_.size() < history_.capacity()) history_.push_back(record);
  if (observer_.on_iteration) observer_.on_iteration(record);
}

Stop StaticProblem::stop_at(std::span<const double> u, bool has_arrived) {
  if (has_arrived) return Stop::arrived;
  const int iterations = statistics_.iterations - iterations_before_;
  if (const Stop limit = limits_.reached(iterations, cpu_seconds() - begun_cpu_, statistics_);
      limit != Stop::none)
    return limit;
  if (has_run_away(configuration_.x())) return Stop::ran_away;
  return does_not_settle(u) ? Stop::unsettled : Stop::none;
}

Balance StaticProblem::balance(std::span<const double> x, std::span<const double> residual) {
  matrices_.need_metric();
  const Numbering& numbering = assembler_.numbering();
  const SparsePattern& pattern = assembler_.pattern();
  Balance b;
  b.scale = std::max(scales_.dead_load(), configuration_.least_load());
  for_nodes(
      numbering, pattern.size, static_cast<std::int32_t>(residual.size()), residual,
      [&](std::uint32_t, double norm, std::int32_t, std::int32_t) { b.scale = std::max(b.scale, norm); });
  for_nodes(numbering, 0, pattern.size, residual,
            [&](std::uint32_t node, double norm, std::int32_t first, std::int32_t last) {
              if (!(norm <= b.residual)) {
                b.residual = norm;
                b.worst = node;
              }
              for (std::int32_t i = first; i < last; ++i) b.floor = std::max(b.floor, rounding_at(i, x));
            });
  const Convergence c = convergence_of(imbalance_of(b), limits_.tolerance);
  b.at_round_off = c == Convergence::at_round_off;
  // The gear must not have run away: far from the start, rounding errors are larger than any residual.
  b.balanced = c != Convergence::none && !has_run_away(x);
  return b;
}

/// Converts a balance to the input of convergence.hpp. Whether an external force acts is determined only if
/// the load does not exceed the rounding error; otherwise, rule (4) of convergence.hpp cannot apply.
Imbalance StaticProblem::imbalance_of(const Balance& b) {
  return {b.residual, b.scale, b.floor, b.scale > b.floor || scales_.is_driven(configuration_.x()),
          configuration_.is_in_time()};
}

/// Upper bound of the residual of one unknown that rounding can cause. Forces are computed from differences
/// of coordinates. Their error is therefore a stiffness times the rounding error of a position or, if x_low
/// is known, of a difference.
double StaticProblem::rounding_at(std::int32_t unknown, std::span<const double> x) const {
  const auto i = static_cast<std::size_t>(unknown);
  const double stiffness = matrices_.metric_at(unknown) + configuration_.stiffness_of_inertia(i);
  return 4 * std::numeric_limits<double>::epsilon() * stiffness * configuration_.rounded_length(x[i]);
}

/// Whether the gear has run away, because practically nothing resists the load. If a node moves by d until
/// its load F is balanced, the stiffness against this load is F/d. A pendulum of length L and weight F has
/// the stiffness F/L by gravity alone. The gear has run away if F/d ≤ kMatters F/L.
bool StaticProblem::has_run_away(std::span<const double> x) const {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    largest = std::max(largest, std::abs(x[i] - assembler_.start()[i]));
  return kMatters * largest > scales_.gear_size();
}

bool StaticProblem::does_not_settle(std::span<const double> u) {
  return std::isfinite(limits_.path) && path_.up_to(u) > limits_.path * scales_.gear_size();
}

double StaticProblem::step_length(const double* du) const {
  double largest = 0;
  for (std::size_t i = 0; i < size(); ++i) largest = std::max(largest, std::abs(du[i]));
  return largest / scales_.element_size();
}

bool StaticProblem::recompute(std::span<const double> u, std::vector<double>& x,
                              std::vector<double>& residual, double& energy) {
  configuration_.place(u);
  x = configuration_.x();
  residual.resize(residual_.size());
  bad_numbers_ = false;
  ++statistics_.energies;
  ++statistics_.residuals;
  if (!assembler_.evaluate(
          x, {.energy = &energy, .residual = residual.data(), .motion = configuration_.motion()}))
    return false;
  bad_numbers_ = !all_finite(residual);
  return !bad_numbers_;
}

netloft_factor StaticProblem::factorise_at(std::span<const double> u, double shift) {
  configuration_.place(u);
  if (!assembler_.evaluate(configuration_.x(), {.matrix = MatrixKind::exact,
                                                .values = matrices_.slots(MatrixKind::exact).data(),
                                                .motion = configuration_.motion()}))
    return NETLOFT_FACTOR_FAILED;
  ++statistics_.matrices;
  return factorise_sum(matrices_.shifted(NETLOFT_EXACT, shift), false);
}

}  // namespace netloft
