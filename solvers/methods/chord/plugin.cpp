// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/solver.hpp>
#include <netloft/vectors.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft {

/// Newton's method that keeps a factorised matrix as long as it is good enough. It is meant for steps in
/// time, whose problems are so similar that one factor can be used for many of them.
///   (A + μ M) s = −r(u),  u ← u + t s,  G(t) = s·r(u + t s)                                  (1)
///   t = 1 if G(1) ≤ η |G(0)|, else where regula falsi finds |G(t)| ≤ η |G(0)|                (2)
///   A is made anew at u if G(0) is more than κ² times that of the step before, or |G(t)| > κ |G(0)|  (3)
///   μ ← 0.1 μ after t > 0.9, 10 μ after t < 0.25, and if s is uphill or no t satisfies (2)   (4)
/// r is the residual at the unknowns u. A is the tangent, or its convex part if the tangent is not positive
/// definite. M is the linear stiffness, in which slack twines count as taut: without a small μ M, steps
/// overstretch slack twines. η is the option `slope`, κ is `contraction`. (2) is the line search of Matthies
/// and Strang (Int. J. Numer. Meth. Eng. 14, 1979). It does not evaluate an energy, because inertia and drag
/// have no potential. A line search in ‖r‖ is not suitable, because ‖r‖ grows when slack twines become taut.
/// −G(0) is the square of Newton's decrement, a length that no stiff twine dominates. The method begins with
/// the factor that the host holds from the previous problem.
struct Chord {
  struct Parameters {
    double damping = 0, contraction = 0, slope = 0, shortest_step = 0;
  };
  static Outcome solve(const Parameters& p, Problem& problem);
};

namespace {

// Range of μ: damping need not exceed the linear stiffness by much, and a μ below the range has no effect.
constexpr double kLargestDamping = 64, kSmallestDamping = 1e-8, kFirstDamping = 1e-3;
constexpr double kDampingToKeep = 1e-5;  // a factor with more damping converges too slowly to be kept

Factor factorise_at_u(Problem& problem, double damping) {
  if (problem.evaluate(problem.u(), Matrix::exact) != Evaluation::ok) return Factor::failed;
  const Factor factor = problem.factorise(Matrix::exact, damping);
  if (factor != Factor::not_positive) return factor;
  if (problem.evaluate(problem.u(), Matrix::convex) != Evaluation::ok) return Factor::failed;
  return problem.factorise(Matrix::convex, damping);
}

class Chords {
 public:
  Chords(const Chord::Parameters& p, Problem& problem)
      : p_(p), problem_(problem), mu_(p.damping), r_(problem.size()), s_(r_), trial_(r_), r_trial_(r_) {}

  Outcome run() {
    if (problem_.evaluate(problem_.u(), energy_, r_) != Evaluation::ok) return Outcome::left_domain;
    while (problem_.progress(problem_.u(), energy_, r_, is_fresh_ ? "" : "old factor")) {
      if (keep_factor() && search_line()) continue;
      if (!renew_factor()) return Outcome::linear_solve;
      while (!search_line())
        if (!raise_damping() || !renew_factor()) return Outcome::step_too_short;
    }
    return Outcome::stopped;
  }

 private:
  /// Solves with the kept factor if (3) allows it. Returns false if there is no kept factor, or if (3)
  /// requires a new one.
  bool keep_factor() {
    if (is_worn_ || !problem_.try_solve(r_, s_)) return false;
    is_fresh_ = false;
    const double before = decrement_;
    return find_slope() && decrement_ <= p_.contraction * p_.contraction * before;
  }

  /// Factorises with increasing damping until s leads downhill. The slope is checked, because the
  /// factorisation of an unsymmetric tangent succeeds even if s leads uphill.
  bool renew_factor() {
    do {
      const Factor factor = factorise_at_u(problem_, mu_);
      if (factor == Factor::failed) return false;
      is_fresh_ = true;
      is_worn_ = false;
      if (factor != Factor::ok) continue;
      problem_.solve(r_, s_);
      if (find_slope()) return true;
    } while (raise_damping());
    return false;
  }
  bool raise_damping() {
    if (mu_ >= kLargestDamping) return false;
    mu_ = std::clamp(10 * mu_, kFirstDamping, kLargestDamping);
    return true;
  }

  /// Computes −G(0). Returns false if s does not lead downhill.
  bool find_slope() {
    for (double& v : s_) v = -v;
    decrement_ = -dot(s_, r_);
    return decrement_ > 0;
  }

  /// Searches t by (2), with one trial if the factor is old. Returns false and keeps u if no t is found.
  bool search_line() {
    double low = 0, high = 0, at_low = -decrement_, at_high = 0;
    for (double t = 1; t - low >= p_.shortest_step;) {
      const bool is_known = evaluate_at(t);
      const double slope = is_known ? dot(s_, r_trial_) : 0;
      is_worn_ = !is_known || std::abs(slope) > p_.contraction * decrement_;
      if (is_known && slope <= p_.slope * decrement_ && (high == 0 || -slope <= p_.slope * decrement_))
        return accept(t);
      if (!is_fresh_) return false;
      if (!is_known) {
        t = low + 0.25 * (t - low);
        continue;
      }
      (slope > 0 ? high : low) = t;
      (slope > 0 ? at_high : at_low) = slope;
      const double share = -at_low / (at_high - at_low);
      t = low + std::clamp(share, 0.1, 0.9) * (high - low);
    }
    return false;
  }

  bool evaluate_at(double t) {
    for (std::size_t i = 0; i < s_.size(); ++i) trial_[i] = problem_.u()[i] + t * s_[i];
    return problem_.evaluate(trial_, energy_trial_, r_trial_) == Evaluation::ok;
  }

  bool accept(double t) {
    if (is_fresh_) {
      is_worn_ = is_worn_ || mu_ > kDampingToKeep;
      adapt_damping(t);
    }
    std::copy(trial_.begin(), trial_.end(), problem_.u().begin());
    r_.swap(r_trial_);
    energy_ = energy_trial_;
    return true;
  }

  /// Changes the damping μ by (4).
  void adapt_damping(double t) {
    if (t > 0.9) mu_ = 0.1 * mu_ < kSmallestDamping ? 0 : 0.1 * mu_;
    if (t < 0.25) raise_damping();
  }

  const Chord::Parameters& p_;
  Problem& problem_;
  double mu_;
  std::vector<double> r_, s_, trial_, r_trial_;
  double energy_ = 0, energy_trial_ = 0;
  double decrement_ = std::numeric_limits<double>::infinity();
  bool is_fresh_ = false, is_worn_ = false;
};

}  // namespace

Outcome Chord::solve(const Parameters& p, Problem& problem) { return Chords(p, problem).run(); }

}  // namespace netloft

using netloft::Chord;

NETLOFT_PLUGIN("chord", "0.2.0", "Newton's method that uses a factorised matrix for several steps") {
  auto& c = plugin.solver<Chord>(
      "chord", "Newton's method that keeps a factorised matrix as long as it is good enough, for time steps");
  c.real("damping", &Chord::Parameters::damping, "1",
         "fraction of the linear stiffness that is first added to a matrix before it is factorised",
         {.lo = 0, .hi = 64, .fallback = 1e-2});
  c.real("contraction", &Chord::Parameters::contraction, "1",
         "fraction of Newton's decrement that may be left after a step; above it a new matrix is factorised",
         {.lo = 1e-6, .hi = 1, .fallback = 0.5});
  c.real("slope", &Chord::Parameters::slope, "1",
         "fraction of the slope at the beginning of a step that may be left at its end",
         {.lo = 1e-3, .hi = 1, .fallback = 0.8});
  c.real("shortest_step", &Chord::Parameters::shortest_step, "1",
         "shortest fraction of a step that is tried with a newly factorised matrix",
         {.lo = 1e-6, .hi = 1, .fallback = 1.0 / 256});
}
