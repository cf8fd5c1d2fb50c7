// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/newton/iterate.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::newton {

Iterate::Iterate(Problem& problem)
    : problem_(problem),
      r_(problem.size()),
      trial_(problem.size()),
      r_trial_(problem.size()),
      d_(problem.conservative() ? 0 : problem.size()) {}

double Iterate::round_off(const Path& path) const {
  return kEnergyRoundOff * (std::abs(energy_) + std::abs(dot(d_, path.s)));
}

bool Iterate::promises_round_off(const Path& path) const { return -slope(path) <= round_off(path); }

bool Iterate::evaluate(Matrix matrix) {
  return problem_.evaluate(problem_.u(), energy_, r_, matrix) == Evaluation::ok;
}

bool Iterate::split_residual() {
  if (d_.empty()) return true;
  double energy = 0;
  if (problem_.evaluate_gradient(problem_.u(), energy, d_) != Evaluation::ok) return false;
  for (std::size_t i = 0; i < d_.size(); ++i) d_[i] = r_[i] - d_[i];
  return true;
}

void Iterate::solve(std::span<double> s) {
  problem_.solve(r_, s);
  for (double& v : s) v = -v;
}

std::optional<std::span<const double>> Iterate::residual_at(const Path& path, double t) {
  double energy = 0;
  move_trial(path, t);
  if (problem_.evaluate(trial_, energy, r_trial_) != Evaluation::ok) return {};
  return r_trial_;
}

std::optional<Sample> Iterate::merit(const Path& path, double t) {
  double energy = 0;
  move_trial(path, t);
  if (problem_.evaluate(trial_, energy, r_trial_) != Evaluation::ok) return {};
  const double slope = dot(r_trial_, path.s) + (path.a.empty() ? 0 : t * dot(r_trial_, path.a));
  if (d_.empty()) return Sample{t, energy, slope};
  if (problem_.evaluate_gradient(trial_, energy, r_trial_) != Evaluation::ok) return {};
  const double work = 0.5 * t * (dot(d_, path.s) + slope - dot(r_trial_, path.s));
  return Sample{t, energy + work, slope};
}

bool Iterate::try_move(const Path& path, double t) {
  if (evaluate_trial(path, t)) return accept_trial(), true;
  evaluate();  // the tangent kept is that of the trial
  return false;
}

bool Iterate::try_move_if_residual_below(const Path& path, double t) {
  if (evaluate_trial(path, t) && dot(r_trial_, r_trial_) <= dot(r_, r_)) return accept_trial(), true;
  evaluate();  // the tangent kept is that of the trial
  return false;
}

bool Iterate::evaluate_trial(const Path& path, double t) {
  move_trial(path, t);
  return problem_.evaluate(trial_, energy_trial_, r_trial_, Matrix::exact) == Evaluation::ok;
}

void Iterate::accept_trial() {
  std::copy(trial_.begin(), trial_.end(), problem_.u().begin());
  std::swap(r_, r_trial_);
  energy_ = energy_trial_;
  ++count_;
}

void Iterate::move_trial(const Path& path, double t) {
  for (std::size_t i = 0; i < trial_.size(); ++i) trial_[i] = problem_.u()[i] + t * path.s[i];
  for (std::size_t i = 0; i < path.a.size(); ++i) trial_[i] += 0.5 * t * t * path.a[i];
}

}  // namespace netloft::newton
