// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/transient_problem.hpp"

#include "framework/balance/shared_unknowns.hpp"
#include "framework/registry/host_function.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace netloft {

namespace {

const char* trouble_of(netloft_outcome outcome, Stop stop) {
  switch (outcome) {
    case NETLOFT_STOPPED:
      return stop == Stop::interrupted ? "interrupted" : "too many iterations in a step";
    case NETLOFT_STEP_TOO_SHORT:
      return "the solver found no balance of the forces in a step";
    case NETLOFT_LINEAR_SOLVE:
      return "the matrix of a step could not be factorised";
    case NETLOFT_LEFT_DOMAIN:
      return "a step led to a state without forces";
    default:
      return "the solver failed in a step";
  }
}

/// Extrapolates an unknown that the elements of a part share from the middle of a step, where its equation
/// holds, to the end of the step. Linear extrapolation to the full end (twice the middle minus the beginning)
/// would oscillate from step to step without decay. If the extrapolation stops a quarter of the step after
/// the middle, errors decay by a factor of √½ per step (|λ| of λ² + λ/2 + 1/2 = 0), and a value that changes
/// at a constant rate lags a quarter of a step behind.
double end_of_shared(double middle, double h, double v) { return middle + 0.25 * h * v; }

}  // namespace

TransientProblem::TransientProblem(Assembler& assembler, double mass_damping, SolverChoice solver,
                                   const MakeFactorisation& make, Limits limits)
    : assembler_(assembler),
      state_(assembler, mass_damping),
      solver_(solver),
      algebra_(assembler, make, limits),
      masses_(assembler),
      zero_(size(), 0.0),
      residual_(assembler.numbering().dofs()) {
  interface_.size = sizeof interface_;
  interface_.unknowns = static_cast<std::uint32_t>(size());
  interface_.host = this;
  interface_.message = message_;
  interface_.message_size = sizeof message_;
  interface_.residual = HostFunction<&TransientProblem::residual>::call;
  interface_.accelerate = HostFunction<&TransientProblem::accelerate>::call;
  interface_.solve = HostFunction<&TransientProblem::solve>::call;
  interface_.solve_between = HostFunction<&TransientProblem::solve_between>::call;
  interface_.scratch = [](void* host, std::uint32_t index) {
    auto& self = *static_cast<TransientProblem*>(host);
    while (self.scratch_.size() <= index) self.scratch_.emplace_back(self.size());
    return self.scratch_[index].data();
  };
}

void TransientProblem::keep_message(const char* text) {
  std::snprintf(message_, sizeof message_, "%s", text);
}

Statistics TransientProblem::statistics() const {
  Statistics all = algebra_.statistics();
  all.residuals += statistics_.residuals;
  all.matrices += statistics_.matrices;
  all.assembly_seconds += statistics_.assembly_seconds;
  return all;
}

int TransientProblem::evaluate() {
  Timed timed(statistics_.assembly_seconds);
  ++statistics_.residuals;
  if (!assembler_.evaluate(state_.x(), {.residual = residual_.data(), .motion = state_.motion()}))
    return assembler_.fault().status;
  double sum = 0;
  for (const double r : residual_) sum += r - r;  // the sum is zero unless a number is infinite or NaN
  return sum == 0 ? NETLOFT_OK : NETLOFT_OUTSIDE_DOMAIN;
}

int TransientProblem::residual(double t, const double* u, const double* v, const double* a, double* r) {
  state_.set(t, {u, size()}, {v, size()}, {a, size()});
  const int status = evaluate();
  std::copy_n(residual_.begin(), size(), r);
  return status;
}

int TransientProblem::accelerate(double t, const double* u, const double* v, double* a) {
  return accelerate_at(t, {u, size()}, {v, size()}, {a, size()}, false);
}

int TransientProblem::start(double t, std::span<const double> u, std::span<const double> v,
                            std::span<double> a) {
  const int status = accelerate_at(t, u, v, a, true);
  if (status == NETLOFT_OK) note_loads(residual_);
  return status;
}

/// Solves M a = −F(t, u, v, 0) for the acceleration a. F is linear in a, with the mass matrix M.
int TransientProblem::accelerate_at(double t, std::span<const double> u, std::span<const double> v,
                                    std::span<double> a, bool massless_rest) {
  state_.set(t, u, v, zero_);
  if (const int status = evaluate(); status != NETLOFT_OK) return status;
  Timed timed(statistics_.assembly_seconds);
  ++statistics_.matrices;
  if (!masses_.update(state_.x())) return assembler_.fault().status;
  return masses_.accelerate({residual_.data(), size()}, a, massless_rest) ? NETLOFT_OK : NETLOFT_ERROR;
}

int TransientProblem::solve(double t, const double* v0, double cv, const double* a0, double ca, double* u) {
  is_between_ = false;
  return solve_step({t, {v0, size()}, {a0, size()}, cv, ca, {}, &state_, least_load_}, u);
}

/// Solves for the displacements m in the middle of the step. The displacements at the end of the step are 2 m
/// − u, and the rates are linear in m.
int TransientProblem::solve_between(const double* v0, double cv, const double* a0, double ca, double damping,
                                    double memory, double* u) {
  const netloft_motion& m = interface_;
  ends_.u.assign(m.u, m.u + size());
  ends_.x_before = assembler_.start();
  ends_.begin = m.t;
  ends_.end = m.t + m.h;
  assembler_.place(ends_.u, ends_.x_before, m.t);
  ends_.ends.length = m.h;
  ends_.ends.damping = damping;
  memory_ = memory;
  is_between_ = true;
  std::vector<double> v(size()), a(size()), middle(size());
  for (std::size_t i = 0; i < size(); ++i) {
    v[i] = v0[i] - cv * m.u[i];
    a[i] = a0[i] - ca * m.u[i];
    middle[i] = 0.5 * (m.u[i] + u[i]);
  }
  StepProblem step{m.t + 0.5 * m.h, v, a, 2 * cv, 2 * ca, {}, &state_, least_load_};
  step.between = &ends_;
  const int status = solve_step(step, middle.data());
  mean_.t = step.t;
  mean_.u = middle;
  mean_.v.resize(size());
  mean_.a.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    mean_.v[i] = v[i] + step.cv * middle[i];
    mean_.a[i] = a[i] + step.ca * middle[i];
  }
  for (std::size_t i = 0; i < size() && status == NETLOFT_OK; ++i)
    u[i] = is_shared(assembler_, i) ? end_of_shared(middle[i], m.h, m.v[i]) : 2 * middle[i] - m.u[i];
  return status;
}

void TransientProblem::place_end(std::span<const double> u) {
  ends_.x_after = assembler_.start();
  assembler_.place(u, ends_.x_after, ends_.end);
  ends_.ends.before = ends_.x_before.data();
  ends_.ends.after = ends_.x_after.data();
}

const MeanStep* TransientProblem::mean_step(std::span<const double> u) {
  if (!is_between_) return nullptr;
  mean_.reactions.clear();
  if (!assembler_.is_guided()) return &mean_;
  mean_.reactions.resize(residual_.size());
  return find_mean_forces(u, mean_.reactions) ? &mean_ : nullptr;
}

bool TransientProblem::find_mean_forces(std::span<const double> u, std::span<double> residual) {
  place_end(u);
  state_.set(mean_.t, mean_.u, mean_.v, mean_.a);
  return assembler_.evaluate(
      state_.x(), {.residual = residual.data(), .motion = state_.motion(), .between = &ends_.ends});
}

bool TransientProblem::find_step_forces(double t, std::span<const double> u, std::span<const double> v,
                                        std::span<const double> a, std::span<double> residual) {
  if (is_between_) return find_mean_forces(u, residual);
  state_.set(t, u, v, a);
  return assembler_.evaluate(state_.x(), {.residual = residual.data(), .motion = state_.motion()});
}

bool TransientProblem::accept(std::span<const double> u) {
  if (!is_between_) return true;
  place_end(u);
  return assembler_.remember_stretch(ends_.ends, memory_, ends_.end);
}

int TransientProblem::solve_step(const StepProblem& asked, double* u) {
  if (mass_.empty() && masses_.update(assembler_.start())) mass_ = masses_.diagonal();
  StepProblem step = asked;
  step.mass = mass_;
  algebra_.begin(step);
  netloft_problem& problem = algebra_.interface();
  std::copy_n(u, size(), problem.u);
  const auto outcome = call_solver(solver_, problem);
  if (outcome == NETLOFT_STOPPED && algebra_.stop() == Stop::arrived) {
    std::copy_n(problem.u, size(), u);
    return NETLOFT_OK;
  }
  trouble_ = trouble_of(outcome, algebra_.stop());
  if (algebra_.stop() == Stop::interrupted || algebra_.met_error()) return NETLOFT_ERROR;
  algebra_.forget_factor();
  return NETLOFT_OUTSIDE_DOMAIN;
}

Pencil TransientProblem::pencil(Pencil::Apply stiffness) const {
  using In = std::span<const double>;
  using Out = std::span<double>;
  return {size(), std::move(stiffness), [this](In x, Out y) { masses_.multiply(x, y); },
          [this](In x, Out y) { masses_.divide(x, y); }};
}

double TransientProblem::highest_frequency() {
  if (!masses_.update(assembler_.start())) return 0;
  netloft_problem& p = algebra_.interface();
  HighestMode mode = find_highest_mode(pencil([&p](std::span<const double> x, std::span<double> y) {
    p.multiply(p.host, NETLOFT_NONE, 1, x.data(), y.data());
  }));
  stiffest_ = std::move(mode.shape);
  return mode.omega;
}

double TransientProblem::highest_frequency_at(std::span<const double> u) {
  std::vector<double> x(residual_.size());
  assembler_.place(u, x);
  netloft_problem& p = algebra_.interface();
  if (!masses_.update(x) ||
      p.evaluate(p.host, NETLOFT_WANT_TANGENT, u.data(), nullptr, nullptr) != NETLOFT_OK)
    return 0;
  const Pencil now = pencil([&p](std::span<const double> in, std::span<double> out) {
    p.multiply(p.host, NETLOFT_EXACT, 0, in.data(), out.data());
  });
  return highest_frequency_near(now, stiffest_);
}

std::string TransientProblem::obstacle_to_explicit(const Scene& scene) {
  if (!masses_.update(assembler_.start())) return assembler_.fault_sentence(scene);
  if (masses_.coupled()) return "masses couple nodes, so that an explicit scheme cannot divide by them";
  if (const auto nodes = masses_.massless_nodes(); !nodes.empty())
    return scene.node_name(nodes.front()) + " has no mass, so that an explicit scheme cannot accelerate it";
  return "";
}

void TransientProblem::note_loads(std::span<const double> residual) {
  const Numbering& numbering = assembler_.numbering();
  for (std::size_t i = 0; i < residual.size();) {
    const std::uint32_t node = numbering.node(Dof(i));
    double sum = 0;
    for (; i < residual.size() && numbering.node(Dof(i)) == node; ++i) sum += residual[i] * residual[i];
    least_load_ = std::max(least_load_, std::sqrt(sum));
  }
}

}  // namespace netloft
