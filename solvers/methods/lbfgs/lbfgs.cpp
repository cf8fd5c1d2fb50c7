// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/lbfgs/lbfgs.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>
#include <functional>
#include <limits>

#include "solvers/adapters/common/round_off.hpp"
#include "solvers/methods/lbfgs/history.hpp"
#include "solvers/methods/lbfgs/wolfe_search.hpp"

namespace netloft::lbfgs {

namespace {

enum Preconditioner { stiffness, diagonal, none };

/// Limit of the first step, for which no curvature is known: the largest displacement of a node, divided by
/// the length of the largest element.
constexpr double kFirstReach = 1;

class Minimiser {
 public:
  Minimiser(const Lbfgs::Parameters& parameters, Problem& problem)
      : p_(parameters),
        problem_(problem),
        memory_(static_cast<std::size_t>(parameters.memory), problem.size()),
        r_(problem.size()),
        Br_(problem.size()),
        step_(problem.size()),
        trial_(problem.size()),
        r_trial_(problem.size()),
        scratch_(problem.size()) {}

  Outcome run() {
    if (!evaluate_here()) return Outcome::left_domain;
    if (!report()) return Outcome::stopped;
    if (!make_preconditioner()) return Outcome::linear_solve;
    precondition(r_, Br_);
    do {
      for (std::int64_t step = 0; step < p_.steps; ++step)
        if (!advance()) return Outcome::step_too_short;
    } while (report());
    return Outcome::stopped;
  }

 private:
  bool evaluate_here() { return problem_.evaluate(problem_.u(), energy_, r_) == Evaluation::ok; }

  bool report() {
    const char* note = note_;
    note_ = "";
    return problem_.progress(problem_.u(), energy_, r_, note);
  }

  bool advance() {
    find_direction();
    if (!search_line()) return forget();
    learn();
    return true;
  }

  bool make_preconditioner() {
    if (p_.preconditioner == stiffness) return problem_.factorise(Matrix::none, 1) == Factor::ok;
    if (p_.preconditioner == diagonal) find_row_sums();
    return true;
  }
  void find_row_sums() {
    row_sums_.resize(problem_.size());
    problem_.row_sums(Matrix::none, 1, row_sums_);
    for (double& sum : row_sums_)
      if (sum <= 0) sum = 1;
  }
  void precondition(std::span<const double> v, std::span<double> Bv) {
    if (p_.preconditioner == stiffness)
      problem_.solve(v, Bv);
    else if (p_.preconditioner == diagonal)
      std::transform(v.begin(), v.end(), row_sums_.begin(), Bv.begin(), std::divides<>());
    else
      std::copy(v.begin(), v.end(), Bv.begin());
  }

  /// Computes the direction p of (1) in lbfgs.hpp.
  void find_direction() {
    memory_.multiply(r_, Br_, scratch_, step_);
    for (double& v : step_) v = -v;
  }

  bool search_line() {
    const Sample start{0, energy_, dot(r_, step_)};
    if (!(start.slope < 0)) return false;
    const LineSearch search{p_.decrease, p_.curvature, kEnergyRoundOff * std::abs(energy_)};
    const auto found = search.find(start, first_length(), [&](double t) { return sample(t); });
    if (!found) return false;
    length_ = found->t;
    energy_ = found->value;
    return true;
  }
  double first_length() {
    return memory_.is_empty() ? std::min(1.0, kFirstReach / problem_.step_length(step_)) : 1;
  }
  Sample sample(double t) {
    for (std::size_t i = 0; i < step_.size(); ++i) trial_[i] = problem_.u()[i] + t * step_[i];
    double energy = 0;
    if (problem_.evaluate(trial_, energy, r_trial_) != Evaluation::ok)
      return {t, std::numeric_limits<double>::infinity(), 0};
    return {t, energy, dot(r_trial_, step_)};
  }

  /// Moves to the trial point, and stores the step s and the change y of the gradient.
  void learn() {
    std::copy(trial_.begin(), trial_.end(), problem_.u().begin());
    std::swap(r_, r_trial_);
    auto &y = r_trial_, &Br = scratch_, &By = Br_;
    precondition(r_, Br);
    for (std::size_t i = 0; i < y.size(); ++i) {
      step_[i] *= length_;
      y[i] = r_[i] - y[i];
      By[i] = Br[i] - By[i];
    }
    if (!memory_.add(step_, y, By)) note_ = "pair left out";
    std::swap(Br_, scratch_);
  }

  /// Begins again with the preconditioner alone. Returns false if the memory of pairs is empty already.
  bool forget() {
    if (memory_.is_empty()) return false;
    note_ = "memory cleared";
    memory_.clear();
    return evaluate_here();
  }

  const Lbfgs::Parameters& p_;
  Problem& problem_;
  Memory memory_;
  double energy_ = 0, length_ = 0;
  const char* note_ = "";
  std::vector<double> r_, Br_, step_, trial_, r_trial_, scratch_, row_sums_;
};

}  // namespace

Outcome Lbfgs::solve(const Parameters& parameters, Problem& problem) {
  return Minimiser(parameters, problem).run();
}

}  // namespace netloft::lbfgs
