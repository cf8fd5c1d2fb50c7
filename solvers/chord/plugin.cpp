// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/solver.hpp>

#include <cmath>

namespace netloft {

/// Newton's method with a matrix that is kept while it serves: for steps in time, whose problems resemble one
/// another so much that one factor does for many.
///   s = −A⁻¹ r(u),  u ← u + t s,  t = 1, ½, ¼ …                                        (1)
///   A is made anew at u when ‖r(u + s)‖ > κ ‖r(u)‖                                      (2)
/// A is the tangent, or its convex part where the tangent is not positive definite. The factor that the host
/// still holds from the problem before is where it begins.
struct Chord {
  struct Parameters {
    double contraction = 0, shortest_step = 0;
  };
  static Outcome solve(const Parameters& p, Problem& problem);
};

namespace {

double norm(std::span<const double> r) {
  double sum = 0;
  for (const double v : r) sum += v * v;
  return std::sqrt(sum);
}

Factor factorise_at_u(Problem& problem) {
  if (problem.evaluate(problem.u(), Matrix::exact) != Evaluation::ok) return Factor::failed;
  const Factor factor = problem.factorise(Matrix::exact, 0);
  if (factor != Factor::not_positive) return factor;
  if (problem.evaluate(problem.u(), Matrix::convex) != Evaluation::ok) return Factor::failed;
  return problem.factorise(Matrix::convex, 0);
}

class Chords {
 public:
  Chords(const Chord::Parameters& p, Problem& problem)
      : p_(p), problem_(problem), r_(problem.size()), s_(r_), trial_(r_), r_trial_(r_) {}

  Outcome run() {
    if (problem_.evaluate(problem_.u(), energy_, r_) != Evaluation::ok) return Outcome::left_domain;
    while (problem_.progress(problem_.u(), energy_, r_, is_fresh_ ? "" : "old factor")) {
      if (problem_.try_solve(r_, s_) && !is_worn_ && take_step(p_.contraction)) continue;
      if (factorise_at_u(problem_) != Factor::ok) return Outcome::linear_solve;
      is_fresh_ = true, is_worn_ = false;
      problem_.solve(r_, s_);
      if (!take_step(1)) return Outcome::step_too_short;
      is_fresh_ = false;
    }
    return Outcome::stopped;
  }

 private:
  /// (1). False: nothing has changed. An old factor gets one try.
  bool take_step(double contraction) {
    const double before = norm(r_);
    for (double t = 1; t >= p_.shortest_step; t *= 0.5) {
      for (std::size_t i = 0; i < s_.size(); ++i) trial_[i] = problem_.u()[i] - t * s_[i];
      double energy = 0;
      const bool is_known = problem_.evaluate(trial_, energy, r_trial_) == Evaluation::ok;
      const double after = is_known ? norm(r_trial_) : 0;
      if (is_known && after <= before) {
        is_worn_ = after > p_.contraction * before;  // (2)
        std::copy(trial_.begin(), trial_.end(), problem_.u().begin());
        r_.swap(r_trial_);
        energy_ = energy;
        return true;
      }
      if (contraction < 1) break;
    }
    return false;
  }

  const Chord::Parameters& p_;
  Problem& problem_;
  std::vector<double> r_, s_, trial_, r_trial_;
  double energy_ = 0;
  bool is_fresh_ = false, is_worn_ = false;
};

}  // namespace

Outcome Chord::solve(const Parameters& p, Problem& problem) { return Chords(p, problem).run(); }

}  // namespace netloft

using netloft::Chord;

NETLOFT_PLUGIN("chord", "0.1.0", "Newton's method with factors that are kept") {
  auto& c =
      plugin.solver<Chord>("chord", "Newton's method that keeps a factor while it serves, for time steps");
  c.real("contraction", &Chord::Parameters::contraction, "1",
         "share of the residual that may be left of a step before the factor is made anew",
         {.lo = 1e-6, .hi = 1, .fallback = 0.25});
  c.real("shortest_step", &Chord::Parameters::shortest_step, "1",
         "shortest part of a step that is tried with a new factor",
         {.lo = 1e-6, .hi = 1, .fallback = 1.0 / 64});
}
