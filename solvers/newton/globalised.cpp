// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "solvers/newton/direction.hpp"
#include "solvers/newton/globalisation.hpp"
#include "solvers/newton/iterate.hpp"
#include "solvers/newton/methods.hpp"
#include "solvers/newton/negative_curvature.hpp"

namespace netloft::newton {

namespace {

/// Less damping than this no longer matters.
constexpr double kSmallestDamping = 1e-12;

double lowered(double damping, double factor) {
  return damping * factor < kSmallestDamping ? 0 : damping * factor;
}
double raised(double damping, double factor) { return std::clamp(damping * factor, 1e-6, kLargestDamping); }

/// A whole step means that the model is trusted; a short one that it reaches too far.
double adapted(double damping, const Step& step) {
  const double t = step.length;
  if (step.rule == Step::Rule::residual) return lowered(damping, 0.1);
  if (step.rule != Step::Rule::energy) return damping;
  if (t > 0.9) return lowered(damping, 0.1);
  if (t > 0.5) return lowered(damping, 0.5);
  return t < 0.25 ? raised(damping, t < 0.1 ? 4 : 2) : damping;
}

class Globalised {
 public:
  Globalised(const Newton::Parameters& parameters, Problem& problem)
      : iterate_(problem),
        curvature_(problem),
        directions_(problem, curvature_),
        globalisation_(parameters, problem.size()),
        damping_(parameters.damping) {
    newton_step_.reserve(problem.size());
  }

  Outcome run() {
    if (!iterate_.evaluate()) return Outcome::left_domain;
    const char* note = "";
    for (bool first = true; iterate_.report(note); first = false) {
      if (!iterate_.split_residual()) return Outcome::left_domain;
      const auto direction = find_direction(first);
      if (!direction) return Outcome::linear_solve;
      note = direction->note;
      const Step step = globalisation_.take(iterate_, *direction);
      damping_ = adapted(direction->damping, step);
      if (direction->nearly_definite && leave_saddle(direction->damping)) continue;
      if (step || (step.is_at_round_off && fall_back())) continue;
      if (damping_ >= kLargestDamping) return Outcome::step_too_short;
      damping_ = raised(damping_, 16);
    }
    return Outcome::stopped;
  }

 private:
  std::optional<Direction> find_direction(bool is_first) {
    if (is_first)
      if (auto found = directions_.find_short(iterate_)) return found;
    return directions_.find(iterate_, damping_);
  }

  bool leave_saddle(double sigma) {
    if (!curvature_.find_direction(iterate_.problem(), sigma) || !curvature_.leave(iterate_)) return false;
    globalisation_.reset_stall_count();
    return true;
  }

  /// Fallback at round-off, where damping leads nowhere: once at a point by Newton's own step, or if this is
  /// a saddle, by (6), or if K is singular, by a step of K + σ M.
  bool fall_back() {
    Problem& problem = iterate_.problem();
    if (damping_ == 0 || fell_back_at_ == iterate_.count() || !iterate_.is_conservative() ||
        !problem.symmetric())
      return false;
    fell_back_at_ = iterate_.count();
    newton_step_.resize(iterate_.size());
    const std::span<double> s = newton_step_;
    if (problem.factorise(Matrix::exact, 0) == Factor::ok) {
      iterate_.solve(s);
      if (!globalisation_.take_newton_step(iterate_, s)) return false;
      damping_ = 0;
      return true;
    }
    const auto sigma = curvature_.factorise_nearly_definite(problem);
    if (!sigma) return false;
    if (curvature_.find_direction(problem, *sigma)) {
      if (!curvature_.leave(iterate_)) return false;
      globalisation_.reset_stall_count();
    } else {
      iterate_.solve(s);
      if (!globalisation_.take_by_slope(iterate_, s)) return false;
    }
    damping_ = *sigma;
    return true;
  }

  Iterate iterate_;
  std::vector<double> newton_step_;  // of fall_back; reserved
  NegativeCurvature curvature_;
  Directions directions_;
  Globalisation globalisation_;
  double damping_;
  std::size_t fell_back_at_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace

Outcome solve_globalised(const Newton::Parameters& parameters, Problem& problem) {
  return Globalised(parameters, problem).run();
}

}  // namespace netloft::newton
