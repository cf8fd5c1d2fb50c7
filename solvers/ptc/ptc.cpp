// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/ptc/methods.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>

namespace netloft::ptc {

namespace {

/// Energies this close cannot be told apart: rounding of a sum of many terms.
constexpr double kEnergyNoise = 1e-13;
constexpr double kShortestStep = 1e-8, kLongestStep = 1e12;
constexpr double kTakenBack = 0.25;

class Continuation {
 public:
  Continuation(const PseudoTransient::Parameters& parameters, Problem& problem)
      : p_(parameters),
        problem_(problem),
        delta_(parameters.step),
        r_(problem.size()),
        s_(problem.size()),
        trial_(problem.size()),
        r_trial_(problem.size()) {}

  Outcome run() {
    if (!evaluate_here()) return Outcome::left_domain;
    while (problem_.progress(problem_.u(), energy_, r_, note_)) {
      note_ = "";
      if (!find_step()) return Outcome::linear_solve;
      if (!take_step() && !take_back()) return Outcome::step_too_short;
    }
    return Outcome::stopped;
  }

 private:
  bool evaluate_here() {
    return problem_.evaluate(problem_.u(), energy_, r_, Matrix::exact) == Evaluation::ok;
  }

  /// Solves (1) for s.
  bool find_step() {
    Factor factor = problem_.factorise(Matrix::exact, 1 / delta_);
    if (factor == Factor::not_positive) factor = factorise_convex_part();
    while (factor == Factor::singular && delta_ > kShortestStep)
      factor = problem_.factorise(Matrix::exact, 1 / (delta_ *= kTakenBack));
    if (factor != Factor::ok) return false;
    problem_.solve(r_, s_);
    for (double& v : s_) v = -v;
    return true;
  }

  Factor factorise_convex_part() {
    note_ = "convex part";
    if (problem_.evaluate(problem_.u(), Matrix::convex) != Evaluation::ok) return Factor::failed;
    Factor factor = problem_.factorise(Matrix::convex, 1 / delta_);
    while (factor == Factor::not_positive && delta_ > kShortestStep)  // by rounding alone
      factor = problem_.factorise(Matrix::convex, 1 / (delta_ *= 0.01));
    return factor;
  }

  bool take_step() {
    if (problem_.step_length(s_) > p_.reach) return false;
    for (std::size_t i = 0; i < s_.size(); ++i) trial_[i] = problem_.u()[i] + s_[i];
    double energy = 0;
    if (problem_.evaluate(trial_, energy, r_trial_, Matrix::exact) != Evaluation::ok || is_worse(energy))
      return false;
    std::copy(trial_.begin(), trial_.end(), problem_.u().begin());
    energy_ = energy;
    std::swap(r_, r_trial_);
    adapt_step();
    return true;
  }

  bool is_worse(double energy) const {
    return problem_.conservative() && energy > energy_ + kEnergyNoise * std::abs(energy_) &&
           norm(r_trial_) > norm(r_);
  }

  /// (2); r_trial_ is the residual before the step.
  void adapt_step() {
    const double ratio = norm(r_trial_) / norm(r_);
    delta_ = std::min(kLongestStep, delta_ * std::clamp(ratio, p_.shrink, p_.growth));
  }

  /// The matrix and the loads that the host keeps are those of the trial; the next step wants those of u.
  bool take_back() {
    note_ = "taken back";
    delta_ *= kTakenBack;
    return evaluate_here() && delta_ > kShortestStep;
  }

  const PseudoTransient::Parameters& p_;
  Problem& problem_;
  double delta_, energy_ = 0;
  const char* note_ = "";
  std::vector<double> r_, s_, trial_, r_trial_;
};

}  // namespace

Outcome solve_linearly_implicitly(const PseudoTransient::Parameters& parameters, Problem& problem) {
  return Continuation(parameters, problem).run();
}

}  // namespace netloft::ptc
