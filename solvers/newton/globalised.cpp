// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/newton/methods.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::newton {

namespace {

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Energies this close cannot be told apart: rounding of a sum of many terms.
constexpr double kEnergyNoise = 1e-13;
// Damping never needs to exceed the metric itself by much, and below the lower end it no longer matters.
constexpr double kLargestDamping = 64, kSmallestDamping = 1e-12;

class Globalised {
 public:
  Globalised(const Newton::Parameters& parameters, Problem& problem)
      : p_(parameters),
        problem_(problem),
        mu_(parameters.damping),
        r_(problem.size()),
        s_(problem.size()),
        trial_(problem.size()),
        r_trial_(problem.size()) {}

  Outcome run() {
    if (problem_.evaluate(problem_.u(), energy_, r_, Matrix::exact) != Evaluation::ok)
      return Outcome::left_domain;
    while (problem_.progress(problem_.u(), energy_, r_, note_)) {
      if (!find_step()) return Outcome::linear_solve;
      if (!search_line()) {
        if (mu_ >= kLargestDamping) return Outcome::step_too_short;
        mu_ = std::clamp(mu_ * 16, 1e-6, kLargestDamping);
      }
    }
    return Outcome::stopped;
  }

 private:
  /// Solves (2) for s, raising μ until the matrix is positive definite.
  bool find_step() {
    note_ = "";
    Factor factor = problem_.factorise(Matrix::exact, mu_);
    shift_ = mu_;
    if (factor == Factor::not_positive) {
      note_ = "convex part";
      if (problem_.evaluate(problem_.u(), Matrix::convex) != Evaluation::ok) return false;
      shift_ = std::max(mu_, 1e-10);
      while ((factor = problem_.factorise(Matrix::convex, shift_)) == Factor::not_positive &&
             shift_ < kLargestDamping)
        shift_ = std::max(shift_ * 100, 1e-8);
    }
    if (factor != Factor::ok) return false;
    problem_.solve(r_, s_);
    for (double& v : s_) v = -v;
    return true;
  }

  /// Moves u along s as (3) wants it; false when no length will do. Trials ask for the energy alone, unless
  /// it has no digits left to tell.
  bool search_line() {
    const double slope = dot(r_, s_);  // −s·(matrix)s < 0
    const double noise = kEnergyNoise * std::abs(energy_);
    double t = 1;
    for (int tries = 0; t >= p_.shortest_step; ++tries) {
      for (std::size_t i = 0; i < s_.size(); ++i) trial_[i] = problem_.u()[i] + t * s_[i];
      if (-t * slope <= noise) return accept_blindly();
      double energy = 0;
      if (problem_.evaluate(trial_, energy) != Evaluation::ok) {
        t *= 0.25;
      } else if (energy <= energy_ + p_.decrease * t * slope) {
        adapt_damping(tries, (energy_ - energy) / (-slope * (t - 0.5 * t * t)));
        return accept();
      } else {
        t *= std::clamp(parabola_minimum(t, energy, slope), 0.1, 0.5);
      }
    }
    return false;
  }

  /// The step of a slope that the energy cannot resolve: good if it does not raise ‖r‖.
  bool accept_blindly() {
    double energy = 0;
    if (problem_.evaluate(trial_, energy, r_trial_, Matrix::exact) == Evaluation::ok &&
        dot(r_trial_, r_trial_) <= dot(r_, r_)) {
      mu_ = lowered(0.1);
      take(energy);
      return true;
    }
    // The matrix kept is that of the trial; the next factorisation wants that of u.
    problem_.evaluate(problem_.u(), energy_, r_, Matrix::exact);
    return false;
  }

  /// Where the parabola through E(0), E'(0), E(t) is lowest, as a fraction of t.
  double parabola_minimum(double t, double energy, double slope) const {
    return -slope * t / (2 * (energy - energy_ - slope * t));
  }

  /// (4): s·(K + shift M)s = −slope, so the model predicts a decrease of −slope (t − t²/2).
  void adapt_damping(int tries, double ratio) {
    if (tries == 0 && ratio > 0.75)
      mu_ = lowered(0.1);
    else if (tries == 0 && ratio > 0.4)
      mu_ = lowered(0.5);
    else if (tries > 1 || ratio < 0.1)
      mu_ = std::clamp(mu_ * 4, 1e-6, kLargestDamping);
  }
  double lowered(double factor) const { return mu_ * factor < kSmallestDamping ? 0 : mu_ * factor; }

  bool accept() {
    double energy = 0;
    if (problem_.evaluate(trial_, energy, r_trial_, Matrix::exact) != Evaluation::ok) return false;
    take(energy);
    return true;
  }
  void take(double energy) {
    std::copy(trial_.begin(), trial_.end(), problem_.u().begin());
    std::swap(r_, r_trial_);
    energy_ = energy;
  }

  const Newton::Parameters& p_;
  Problem& problem_;
  double mu_, shift_ = 0, energy_ = 0;
  const char* note_ = "";
  std::vector<double> r_, s_, trial_, r_trial_;
};

}  // namespace

Outcome solve_globalised(const Newton::Parameters& parameters, Problem& problem) {
  return Globalised(parameters, problem).run();
}

}  // namespace netloft::newton
