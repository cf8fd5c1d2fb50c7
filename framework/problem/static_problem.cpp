// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/static_problem.hpp"

#include "framework/registry/host_function.hpp"
#include "framework/registry/plugin_call.hpp"

#include <netloft/imbalance.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace netloft {

namespace {

MatrixKind kind_of(std::uint32_t want) {
  if (want & NETLOFT_WANT_TANGENT) return MatrixKind::exact;
  if (want & NETLOFT_WANT_CONVEX) return MatrixKind::convex;
  return MatrixKind::none;
}

/// Calls visit(node, norm of the node's entries) for entries begin … end, which come node by node.
template <class Visit>
void for_nodes(const Numbering& numbering, std::int32_t begin, std::int32_t end, std::span<const double> v,
               Visit&& visit) {
  for (std::int32_t i = begin; i < end;) {
    const std::uint32_t node = numbering.node(Dof(i));
    const std::int32_t first = i;
    double sum = 0;
    for (; i < end && numbering.node(Dof(i)) == node; ++i)
      sum += v[static_cast<std::size_t>(i)] * v[static_cast<std::size_t>(i)];
    visit(node, first, i, std::sqrt(sum));
  }
}

bool all_finite(std::span<const double> v) {
  double sum = 0;
  for (const double a : v) sum += a - a;  // zero unless something is infinite or no number
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

netloft_outcome call_solver(const SolverType& solver, const void* parameters, netloft_problem& problem) {
  const PluginCall call({solver.type.c_str(), "solve", nullptr, CallFrame::Kind::method});
  return static_cast<netloft_outcome>(solver.solver.solve(parameters, &problem));
}

StaticProblem::StaticProblem(Assembler& assembler, MakeFactorisation make, Limits limits,
                             std::function<void(const IterationRecord&)> on_iteration)
    : assembler_(assembler),
      make_(std::move(make)),
      limits_(limits),
      on_iteration_(std::move(on_iteration)),
      begun_(wall_seconds()),
      begun_cpu_(cpu_seconds()),
      u_(static_cast<std::size_t>(assembler.pattern().size), 0.0),
      x_(assembler.start()),
      residual_(assembler.numbering().dofs()) {
  history_.reserve(static_cast<std::size_t>(std::max(0, limits.iterations)) + 2);
  interface_.size = sizeof interface_;
  interface_.unknowns = static_cast<std::uint32_t>(u_.size());
  interface_.host = this, interface_.u = u_.data();
  interface_.message = message_, interface_.message_size = sizeof message_;
  interface_.traits = traits_of(assembler);
  interface_.evaluate = HostFunction<&StaticProblem::evaluate>::call;
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
  // No iteration allocates, whichever matrix it is the first to want; memory that is not wanted is not
  // touched.
  for (auto* matrix : {&exact_, &convex_, &metric_, &shifted_}) matrix->reserve(assembler.value_slots());
  for (auto* vector : {&reactions_of_, &gradient_}) vector->reserve(residual_.size());
  find_dead_loads();
  if (const double largest = largest_extent(x_); largest > 0) element_size_ = largest;
  gear_size_ = largest_distance();
}

/// Between coordinates of the start; what is no place of a node is left out.
double StaticProblem::largest_distance() const {
  double largest = 1;
  for (std::size_t i = 0; i < x_.size(); ++i)
    if (assembler_.is_place(i)) largest = std::max(largest, std::abs(x_[i] - x_[0]));
  return largest;
}

void StaticProblem::keep_message(const char* text) { std::snprintf(message_, sizeof message_, "%s", text); }

std::vector<double> StaticProblem::sum_of_terms(bool (*counts)(std::uint32_t traits)) {
  std::vector<double> term(residual_.size()), sum(residual_.size(), 0.0);
  for (std::size_t f = 0; f < assembler_.families().size(); ++f) {
    const auto& terms = assembler_.families()[f]->active_terms();
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (!counts(terms[t].traits) || !assembler_.evaluate_term(x_, f, t, term)) continue;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += term[i];
    }
  }
  return sum;
}

void StaticProblem::find_dead_loads() {
  const auto sum = sum_of_terms([](std::uint32_t traits) { return (traits & NETLOFT_CONSTANT) != 0; });
  for_nodes(assembler_.numbering(), 0, assembler_.pattern().size, sum,
            [&](std::uint32_t, std::int32_t, std::int32_t, double norm) {
              dead_load_ = std::max(dead_load_, norm);
            });
}

StaticProblem::DrivingLoad StaticProblem::driving_load() {
  const auto sum = sum_of_terms([](std::uint32_t traits) {
    return (traits & NETLOFT_CONSTANT) != 0 || (traits & NETLOFT_CONSERVATIVE) == 0;
  });
  DrivingLoad load;
  for_nodes(assembler_.numbering(), 0, assembler_.pattern().size, sum,
            [&](std::uint32_t, std::int32_t, std::int32_t, double norm) {
              load.largest = std::max(load.largest, norm), load.sum += norm;
            });
  return load;
}

/// Whether some force acts that is not of elements alone.
bool StaticProblem::is_driven() {
  if (!is_driven_) {
    const auto sum = sum_of_terms([](std::uint32_t traits) {
      return (traits & (NETLOFT_CONSTANT | NETLOFT_FROM_OUTSIDE)) != 0 ||
             (traits & NETLOFT_CONSERVATIVE) == 0;
    });
    is_driven_ = std::any_of(sum.begin(), sum.end(), [](double force) { return force != 0; });
  }
  return *is_driven_;
}

/// Of an element, along an axis.
double StaticProblem::largest_extent(std::span<const double> x) const {
  double largest = 0;
  const Numbering& numbering = assembler_.numbering();
  const auto at = [&](std::uint32_t node, int axis) { return x[numbering.dof(node, axis).at()]; };
  for (const auto& family : assembler_.families())
    for (std::size_t e = 0; e < family->size(); ++e)
      for (int corner = 1; corner < family->nodes_per_element(); ++corner)
        for (int axis = 0; axis < 3; ++axis)
          largest =
              std::max(largest, std::abs(at(family->node(e, corner), axis) - at(family->node(e, 0), axis)));
  return largest;
}

void StaticProblem::begin(const StepProblem& step) {
  step_ = step;
  stop_ = Stop::none;
  reactions_of_.clear();
  iterations_before_ = statistics_.iterations;
  v_.resize(u_.size()), a_.resize(u_.size());
}

void StaticProblem::count_from(std::vector<double> base) {
  base_ = std::move(base);
  x_low_.assign(base_.size(), 0.0);
  motion_.x_low = x_low_.data();
  base_extent_ = largest_extent(base_);
  reactions_of_.clear();
}

const std::vector<double>& StaticProblem::positions(std::span<const double> u) {
  place(u.data());
  return x_;
}

void StaticProblem::place(const double* u) {
  if (!base_.empty()) return assembler_.place_from(base_, {u, u_.size()}, x_, x_low_);
  if (!step_.state) return assembler_.place({u, u_.size()}, x_);
  for (std::size_t i = 0; i < u_.size(); ++i)
    v_[i] = step_.v0[i] + step_.cv * u[i], a_[i] = step_.a0[i] + step_.ca * u[i];
  step_.state->set(step_.t, {u, u_.size()}, v_, a_);
  motion_ = step_.state->motion(step_.cv, step_.ca);
  x_ = step_.state->x();
  if (step_.between) place_end(u);
}

/// Where a step ends whose middle is u.
void StaticProblem::place_end(const double* u) {
  StepProblem::Ends& step = *step_.between;
  for (std::size_t i = 0; i < u_.size(); ++i) a_[i] = 2 * u[i] - step.u[i];
  step.x_after = assembler_.start();  // of what is held, too
  assembler_.place(a_, step.x_after, step.end);
  step.ends.before = step.x_before.data(), step.ends.after = step.x_after.data();
}

int StaticProblem::evaluate(std::uint32_t want, const double* u, double* energy, double* residual) {
  const MatrixKind kind = kind_of(want);
  statistics_.energies += energy != nullptr, statistics_.residuals += residual != nullptr,
      statistics_.matrices += kind != MatrixKind::none;
  Timed timed(statistics_.assembly_seconds);
  bad_numbers_ = met_error_ = false;
  place(u);
  Request request;
  request.conservative_only = want & NETLOFT_WANT_GRADIENT;
  // Mean forces of a step are the gradient of nothing: solvers are to weigh them like those without energy.
  if (energy && step_.between) *energy = 0;
  request.energy = step_.between ? nullptr : energy;
  if (request.conservative_only && step_.between) {
    if (residual) std::fill_n(residual, u_.size(), 0.0);
    return NETLOFT_OK;
  }
  auto& all = request.conservative_only ? gradient_ : residual_;
  all.resize(x_.size());
  request.residual = residual ? all.data() : nullptr;
  request.matrix = kind;
  request.values = kind == MatrixKind::none ? nullptr : values(kind).data();
  request.motion = motion_;
  request.between = step_.between ? &step_.between->ends : nullptr;
  if (!assembler_.evaluate(x_, request)) {
    met_error_ = assembler_.fault().status == NETLOFT_ERROR;
    return assembler_.fault().status;
  }
  if (residual) std::copy_n(all.begin(), u_.size(), residual);
  if (residual && !request.conservative_only) reactions_of_.assign(u, u + u_.size());
  bad_numbers_ = (energy && !std::isfinite(*energy)) || (residual && !all_finite(all));
  return bad_numbers_ ? NETLOFT_OUTSIDE_DOMAIN : NETLOFT_OK;
}

std::vector<double>& StaticProblem::values(MatrixKind kind) {
  auto& v = kind == MatrixKind::exact ? exact_ : kind == MatrixKind::convex ? convex_ : metric_;
  v.resize(assembler_.value_slots());
  return v;
}

void StaticProblem::need_metric() {
  if (!metric_.empty()) return;
  Timed timed(statistics_.assembly_seconds);
  if (!assembler_.evaluate(assembler_.start(),
                           {.matrix = MatrixKind::metric, .values = values(MatrixKind::metric).data()}))
    metric_.assign(assembler_.value_slots(), 0.0);
}

/// matrix + shift x metric, over the entries of the pattern.
std::span<const double> StaticProblem::shifted(int matrix, double shift) {
  const std::size_t entries = assembler_.pattern().value_slots();
  const std::vector<double>* base = matrix == NETLOFT_EXACT    ? &exact_
                                    : matrix == NETLOFT_CONVEX ? &convex_
                                                               : nullptr;
  if (base && base->empty()) return {};
  if (shift == 0 && base) return {base->data(), entries};
  need_metric();
  shifted_.resize(entries);
  for (std::size_t i = 0; i < entries; ++i) shifted_[i] = (base ? (*base)[i] : 0.0) + shift * metric_[i];
  return shifted_;
}

/// exact + share x (convex - exact) + shift x metric, over the entries of the pattern.
std::span<const double> StaticProblem::between(double share, double shift) {
  if (exact_.empty() || convex_.empty()) return {};
  need_metric();
  const std::size_t entries = assembler_.pattern().value_slots();
  shifted_.resize(entries);
  for (std::size_t i = 0; i < entries; ++i)
    shifted_[i] = exact_[i] + share * (convex_[i] - exact_[i]) + shift * metric_[i];
  return shifted_;
}

int StaticProblem::factorise(int matrix, double shift) {
  return factorise_and_count(matrix_class(matrix & NETLOFT_INDEFINITE),
                             shifted(matrix & ~NETLOFT_INDEFINITE, shift));
}

int StaticProblem::factorise_between(double share, double shift) {
  return factorise_and_count(matrix_class(false), between(share, shift));
}

netloft_factor StaticProblem::factorise_and_count(MatrixClass kind, std::span<const double> v) {
  if (v.empty() && !u_.empty()) return NETLOFT_FACTOR_FAILED;
  const netloft_factor code = factorise_as(kind, v);
  ++statistics_.factorisations;
  statistics_.refused_factorisations += code != NETLOFT_FACTOR_OK;
  return code;
}

MatrixClass StaticProblem::matrix_class(bool may_be_indefinite) const {
  if (!assembler_.pattern().symmetric) return MatrixClass::unsymmetric;
  return may_be_indefinite ? MatrixClass::symmetric : MatrixClass::positive_definite;
}

netloft_factor StaticProblem::factorise_as(MatrixClass kind, std::span<const double> v) {
  auto& factorisation = factorisations_[static_cast<std::size_t>(kind)];
  if (!factorisation) {
    Timed timed(statistics_.analysis_seconds);
    auto fresh = make_(kind);
    fresh->analyse(assembler_.pattern());
    factorisation = std::move(fresh);
  }
  Timed timed(statistics_.factorisation_seconds);
  last_ = factorisation.get();
  factor_result_ = factorisation->factorise(v);
  return factor_code(factor_result_.status);
}

int StaticProblem::solve(const double* rhs, double* x) {
  if (!last_ || factor_result_.status != FactorStatus::ok) return NETLOFT_ERROR;
  Timed timed(statistics_.solve_seconds);
  ++statistics_.solves;
  last_->solve({rhs, u_.size()}, {x, u_.size()});
  return NETLOFT_OK;
}

namespace {

/// Calls visit(row, column, value) for every entry of the whole matrix.
template <class Visit>
void for_matrix(const SparsePattern& p, std::span<const double> values, Visit&& visit) {
  for (std::size_t c = 0; c < static_cast<std::size_t>(p.size); ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[c]);
         k < static_cast<std::size_t>(p.column_start[c + 1]); ++k) {
      const auto r = static_cast<std::size_t>(p.row[k]);
      const double a = values[p.slot_of(k)];
      visit(r, c, a);
      if (p.symmetric && r != c) visit(c, r, a);
    }
}

}  // namespace

int StaticProblem::multiply(int matrix, double shift, const double* x, double* y) {
  const auto v = shifted(matrix, shift);
  if (v.empty() && !u_.empty()) return NETLOFT_ERROR;
  std::fill_n(y, u_.size(), 0.0);
  for_matrix(assembler_.pattern(), v, [&](std::size_t r, std::size_t c, double a) { y[r] += a * x[c]; });
  return NETLOFT_OK;
}

int StaticProblem::row_sums(int matrix, double shift, double* y) {
  const auto v = shifted(matrix, shift);
  if (v.empty() && !u_.empty()) return NETLOFT_ERROR;
  std::fill_n(y, u_.size(), 0.0);
  for_matrix(assembler_.pattern(), v, [&](std::size_t r, std::size_t, double a) { y[r] += std::abs(a); });
  return NETLOFT_OK;
}

/// Tolerances are a part of the reactions at u, whichever point was evaluated last.
void StaticProblem::find_reactions(const double* u, const double* residual) {
  if (!std::equal(u, u + u_.size(), reactions_of_.begin(), reactions_of_.end())) {
    gradient_.resize(x_.size());
    evaluate(NETLOFT_WANT_FORCE, u, nullptr, gradient_.data());
  }
  std::copy_n(residual, u_.size(), residual_.begin());
}

int StaticProblem::progress(const double* u, double energy, const double* residual, const char* note) {
  find_reactions(u, residual);
  place(u);
  const Balance b = balance(x_, residual_);
  const bool was_before = !step_.state && !history_.empty();
  const bool arrived =
      was_before ? may_stop(b.convergence(), b.residual, history_.back().residual) : b.balanced;
  IterationRecord record{statistics_.iterations,  b.residual, b.scale, energy, statistics_.factorisations,
                         wall_seconds() - begun_, ""};
  std::snprintf(record.note, sizeof record.note, "%s", note ? note : "");
  if (history_.size() < history_.capacity()) history_.push_back(record);
  if (on_iteration_) on_iteration_(record);
  if (limits_.kept && base_.empty() && !step_.state) limits_.kept->keep({u, u_.size()}, b.residual, b.scale);
  if (arrived)
    stop_ = Stop::arrived;
  else if (limits_.interrupt && limits_.interrupt->load())
    stop_ = Stop::interrupted;
  else if (statistics_.iterations - iterations_before_ >= limits_.iterations)
    stop_ = Stop::iterations;
  else if (cpu_seconds() - begun_cpu_ >= limits_.seconds)
    stop_ = Stop::time;
  else if (limits_.model && limits_.model->of(statistics_) >= limits_.work)
    stop_ = Stop::work;
  else if (has_run_away(x_))
    stop_ = Stop::ran_away;
  else if (does_not_settle(u))
    stop_ = Stop::unsettled;
  if (stop_ != Stop::none) return stop_ == Stop::arrived ? NETLOFT_ARRIVED : NETLOFT_GIVE_UP;
  ++statistics_.iterations;
  return NETLOFT_GO_ON;
}

Balance StaticProblem::balance(std::span<const double> x, std::span<const double> residual) {
  need_metric();
  const Numbering& numbering = assembler_.numbering();
  const SparsePattern& pattern = assembler_.pattern();
  Balance b;
  b.scale = std::max(dead_load_, step_.least_load);
  for_nodes(
      numbering, pattern.size, static_cast<std::int32_t>(residual.size()), residual,
      [&](std::uint32_t, std::int32_t, std::int32_t, double norm) { b.scale = std::max(b.scale, norm); });
  for_nodes(numbering, 0, pattern.size, residual,
            [&](std::uint32_t node, std::int32_t first, std::int32_t last, double norm) {
              if (!(norm <= b.residual)) b.residual = norm, b.worst = node;
              for (std::int32_t i = first; i < last; ++i) b.floor = std::max(b.floor, rounding_at(i, x));
            });
  const Convergence c = convergence_of(imbalance_of(b), limits_.tolerance);
  b.at_round_off = c == Convergence::at_round_off;
  b.balanced = c != Convergence::none && !has_run_away(x);  // where rounding would excuse anything
  return b;
}

/// What drives the gear is asked for only where it matters: with no more load than rounding.
Imbalance StaticProblem::imbalance_of(const Balance& b) {
  return {b.residual, b.scale, b.floor, b.scale > b.floor || is_driven(), step_.state != nullptr};
}

/// Forces come from differences of coordinates: stiffness x rounding of the position is what they are worth;
/// of the difference, where positions keep all their digits.
double StaticProblem::rounding_at(std::int32_t unknown, std::span<const double> x) const {
  const auto i = static_cast<std::size_t>(unknown);
  double stiffness = metric_[find_slot(assembler_.pattern(), unknown, unknown)];
  if (step_.state) stiffness += step_.ca * step_.mass[i];
  const double largest = base_.empty() ? std::abs(x[i]) : base_extent_;
  return 4 * std::numeric_limits<double>::epsilon() * stiffness * largest;
}

/// So far from the start that the gear's size no longer matters: nothing holds what drives it.
bool StaticProblem::has_run_away(std::span<const double> x) const {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    largest = std::max(largest, std::abs(x[i] - assembler_.start()[i]));
  return kMatters * largest > gear_size_;
}

/// Sums up the largest moves from one accepted point to the next.
bool StaticProblem::does_not_settle(const double* u) {
  if (!std::isfinite(limits_.path)) return false;
  double largest = 0;
  for (std::size_t i = 0; i < path_from_.size(); ++i)
    largest = std::max(largest, std::abs(u[i] - path_from_[i]));
  path_from_.assign(u, u + u_.size());
  return (path_ += largest) > limits_.path * gear_size_;
}

double StaticProblem::step_length(const double* du) const {
  double largest = 0;
  for (std::size_t i = 0; i < u_.size(); ++i) largest = std::max(largest, std::abs(du[i]));
  return largest / element_size_;
}

bool StaticProblem::recompute(std::span<const double> u, std::vector<double>& x,
                              std::vector<double>& residual, double& energy) {
  place(u.data());
  x = x_;
  residual.resize(residual_.size());
  bad_numbers_ = false;
  ++statistics_.energies, ++statistics_.residuals;
  if (!assembler_.evaluate(x, {.energy = &energy, .residual = residual.data(), .motion = motion_}))
    return false;
  bad_numbers_ = !all_finite(residual);
  return !bad_numbers_;
}

netloft_factor StaticProblem::factorise_at(std::span<const double> u, double shift) {
  place(u.data());
  if (!assembler_.evaluate(
          x_, {.matrix = MatrixKind::exact, .values = values(MatrixKind::exact).data(), .motion = motion_}))
    return NETLOFT_FACTOR_FAILED;
  ++statistics_.matrices;
  return factorise_and_count(MatrixClass::positive_definite, shifted(NETLOFT_EXACT, shift));
}

std::string StaticProblem::factorisation_name() const { return last_ ? last_->description() : "none"; }

}  // namespace netloft
