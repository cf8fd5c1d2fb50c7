// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/iterate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace netloft::newton {

Iterate::Iterate(Problem& problem)
    : problem_(problem),
      r_(problem.size()),
      trial_(problem.size()),
      r_trial_(problem.size()),
      gradient_(problem.conservative() ? 0 : problem.size()),
      d_(problem.conservative() ? 0 : problem.size()) {}

double Iterate::round_off(const Path& path) const {
  return kEnergyRoundOff * (std::abs(energy_) + std::abs(dot(d_, path.s)));
}

bool Iterate::promises_round_off(const Path& path) const { return -slope(path) <= round_off(path); }

bool Iterate::evaluate(Matrix matrix) {
  return problem_.evaluate(problem_.u(), energy_, r_, matrix) == Evaluation::ok;
}

bool Iterate::split_residual() {
  if (d_.empty() || is_split_) return true;
  double energy = 0;
  if (problem_.evaluate_gradient(problem_.u(), energy, gradient_) != Evaluation::ok) return false;
  find_nonconservative(gradient_);
  return true;
}

void Iterate::find_nonconservative(std::span<const double> gradient) {
  for (std::size_t i = 0; i < d_.size(); ++i) d_[i] = r_[i] - gradient[i];
  is_split_ = true;
}

void Iterate::solve(std::span<double> s) {
  problem_.solve(r_, s);
  for (double& v : s) v = -v;
}

std::optional<std::span<const double>> Iterate::residual_at(const Path& path, double t) {
  if (!evaluate_trial(path, t, Known::residual)) return {};
  return r_trial_;
}

std::optional<Sample> Iterate::merit(const Path& path, double t) {
  assert(d_.empty() || is_split_);
  if (!evaluate_trial(path, t, d_.empty() ? Known::residual : Known::gradient_too)) return {};
  const double slope = dot(r_trial_, path.s) + (path.a.empty() ? 0 : t * dot(r_trial_, path.a));
  if (d_.empty()) return Sample{t, energy_trial_, slope};
  const double work = 0.5 * t * (dot(d_, path.s) + slope - dot(gradient_, path.s));
  return Sample{t, energy_trial_ + work, slope};
}

bool Iterate::try_move(const Path& path, double t) {
  if (keep_tangent_of_trial(path, t)) return accept_trial(), true;
  evaluate();  // restores the tangent at u, which the tangent at the trial point has replaced
  return false;
}

bool Iterate::try_move_if_residual_below(const Path& path, double t) {
  if (keep_tangent_of_trial(path, t) && dot(r_trial_, r_trial_) <= dot(r_, r_)) return accept_trial(), true;
  evaluate();  // restores the tangent at u, which the tangent at the trial point has replaced
  return false;
}

/// Evaluates at u(t), unless u(t) is bit for bit the last trial point and `wanted` is known there.
bool Iterate::evaluate_trial(const Path& path, double t, Known wanted) {
  if (!move_trial(path, t) && known_ >= wanted) return true;
  known_ = Known::nothing;
  const Evaluation done = wanted == Known::gradient_too
                              ? problem_.evaluate_both(trial_, energy_trial_, r_trial_, gradient_)
                              : problem_.evaluate(trial_, energy_trial_, r_trial_);
  if (done == Evaluation::ok) known_ = wanted;
  return known_ == wanted;
}

bool Iterate::keep_tangent_of_trial(const Path& path, double t) {
  if (!move_trial(path, t) && known_ != Known::nothing)
    return problem_.evaluate(trial_, Matrix::exact) == Evaluation::ok;
  known_ = Known::nothing;
  if (problem_.evaluate(trial_, energy_trial_, r_trial_, Matrix::exact) != Evaluation::ok) return false;
  known_ = Known::residual;
  return true;
}

void Iterate::accept_trial() {
  std::copy(trial_.begin(), trial_.end(), problem_.u().begin());
  std::swap(r_, r_trial_);
  energy_ = energy_trial_;
  is_split_ = false;
  if (known_ == Known::gradient_too) find_nonconservative(gradient_);
  known_ = Known::nothing;
  ++count_;
}

/// Moves the trial point to u(t). Returns false if the trial point was there already.
bool Iterate::move_trial(const Path& path, double t) {
  bool moves = false;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    double there = problem_.u()[i] + t * path.s[i];
    if (!path.a.empty()) there += 0.5 * t * t * path.a[i];
    moves |= there != trial_[i];
    trial_[i] = there;
  }
  return moves;
}

}  // namespace netloft::newton
