// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/ptc/ptc.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>

namespace netloft::ptc {

namespace {

// Range of the step δ. With a shorter step, M/δ leaves only half of the digits of K; with a longer step, M/δ
// is lost in the rounding of K.
constexpr double kShortestStep = 0x1p-26, kLongestStep = 0x1p52;
// Largest growth of the driving force d·r during a step, the factor 2 of (3) in ptc.hpp.
constexpr double kMostGrowth = 2;

class ImplicitSteps {
 public:
  ImplicitSteps(const PseudoTransient::Parameters& parameters, Problem& problem)
      : p_(parameters),
        problem_(problem),
        r_(problem.size()),
        r_before_(problem.size()),
        before_(problem.size()),
        moved_(problem.size()),
        unbalanced_(problem.size()),
        s_(problem.size()) {}

  Outcome run() {
    if (!evaluate_here()) return Outcome::left_domain;
    while (problem_.progress(problem_.u(), energy_, r_, note_)) {
      note_ = "";
      keep_place();
      if (!take_step() && !take_back()) return Outcome::step_too_short;
    }
    return Outcome::stopped;
  }

 private:
  bool evaluate_here() {
    return problem_.evaluate(problem_.u(), energy_, r_, Matrix::exact) == Evaluation::ok;
  }

  void keep_place() {
    std::copy(problem_.u().begin(), problem_.u().end(), before_.begin());
    r_before_ = r_;
    std::fill(moved_.begin(), moved_.end(), 0.0);
  }

  /// Solves (1) of ptc.hpp by corrections (2) for one step in time, and adapts its length δ.
  bool take_step() {
    for (std::int64_t corrections = 1; corrections <= p_.corrections; ++corrections) {
      if (!correct()) return false;
      if (problem_.step_length(s_) > p_.solved * problem_.step_length(moved_)) continue;
      if (!follows_motion()) return false;
      adapt_step(corrections);
      return true;
    }
    return false;
  }

  /// Takes one correction s of (2) in ptc.hpp, and evaluates the residual there.
  bool correct() {
    if (problem_.factorise(Matrix::exact, 1 / delta_) != Factor::ok) return false;
    problem_.multiply(Matrix::none, 1 / delta_, moved_, unbalanced_);
    axpy(1, r_, unbalanced_);
    problem_.solve(unbalanced_, s_);
    axpy(-1, s_, moved_);
    for (std::size_t i = 0; i < s_.size(); ++i) problem_.u()[i] = before_[i] + moved_[i];
    return evaluate_here();
  }

  /// Whether (3) of ptc.hpp holds. A step that violates it does not follow the motion.
  bool follows_motion() { return dot(moved_, r_) >= kMostGrowth * dot(moved_, r_before_); }

  void adapt_step(std::int64_t corrections) {
    if (2 * corrections <= p_.corrections) delta_ = std::min(kLongestStep, 2 * delta_);
  }

  bool take_back() {
    note_ = "taken back";
    delta_ /= 2;
    std::copy(before_.begin(), before_.end(), problem_.u().begin());
    return evaluate_here() && delta_ > kShortestStep;
  }

  const PseudoTransient::Parameters& p_;
  Problem& problem_;
  double delta_ = 1, energy_ = 0;
  const char* note_ = "";
  std::vector<double> r_, r_before_;  // residual at u, and at the point where the step began
  std::vector<double> before_, moved_, unbalanced_, s_;
};

}  // namespace

Outcome PseudoTransient::solve(const Parameters& parameters, Problem& problem) {
  return ImplicitSteps(parameters, problem).run();
}

}  // namespace netloft::ptc
