// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <optional>
#include <vector>

#include "solvers/newton/direction.hpp"
#include "solvers/newton/iterate.hpp"
#include "solvers/newton/methods.hpp"
#include "solvers/newton/negative_curvature.hpp"
#include "solvers/newton/step_rules.hpp"

namespace netloft::newton {

namespace {

/// From this t on a step means that the model is trusted, below it that it reaches too far.
constexpr double kTrusted = 0.5;

double adapted(double damping, double end, const Step& step, const Newton::Parameters& p) {
  if (step.rule == Step::Rule::residual) return lowered(damping, end, p);
  if (step.rule != Step::Rule::energy) return damping;
  return step.length > kTrusted ? lowered(damping, end, p) : raised(damping, kTrusted / step.length, p);
}

class Globalised {
 public:
  Globalised(const Newton::Parameters& parameters, Problem& problem)
      : iterate_(problem),
        curvature_(parameters, problem),
        directions_(parameters, problem, curvature_),
        rules_(parameters, problem.size()),
        p_(parameters),
        end_(problem.symmetric() ? parameters.least_damping : std::numeric_limits<double>::epsilon()),
        damping_(parameters.damping) {
    step_.reserve(problem.size());
  }

  Outcome run() {
    if (!iterate_.evaluate()) return Outcome::left_domain;
    const char* note = "";
    // `report` is false when the host says stop: the iteration has arrived, or a limit is reached.
    for (bool first = true; iterate_.report(note); first = false) {
      if (!iterate_.split_residual()) return Outcome::left_domain;
      const auto direction = find_direction(first);
      if (!direction) return directions_.led_uphill() ? Outcome::step_too_short : Outcome::linear_solve;
      note = direction->note;
      const Step step = rules_.take(iterate_, *direction);
      damping_ = adapted(direction->damping, end_, step, p_);
      if (direction->nearly_definite && leave_saddle(direction->damping)) continue;
      if (step || (step.is_at_round_off && fall_back())) continue;
      if (damping_ >= p_.most_damping) return Outcome::step_too_short;
      damping_ = raised(damping_, p_.factor, p_);
    }
    return Outcome::stopped;
  }

 private:
  std::optional<Direction> find_direction(bool is_first) {
    if (is_first)
      if (auto found = directions_.find_short_undamped(iterate_)) return found;
    return directions_.find(iterate_, damping_);
  }

  /// (6), after the step by K + σ M: with the factor that gave it, from where it has led. Over that step the
  /// direction in which K curves most downwards changes little, so that the old factor finds it at the new
  /// point.
  bool leave_saddle(double sigma) {
    const auto v = curvature_.find_direction(iterate_.problem(), sigma);
    return v && leave_along(*v);
  }

  bool leave_along(std::span<const double> v) {
    if (!curvature_.leave_along(v, iterate_)) return false;
    rules_.reset_stall_count();
    return true;
  }

  /// At round-off, where damping leads nowhere, once at every point: by Newton's own step; or where K is
  /// nearly definite, off the saddle; or where nothing curves downwards, either, by a step of K + σ M.
  bool fall_back() {
    if (!may_fall_back()) return false;
    fell_back_at_ = iterate_.count();
    Problem& problem = iterate_.problem();
    if (problem.factorise(Matrix::exact, 0) == Factor::ok) return goes_on_with(0, take_undamped());
    const auto sigma = curvature_.factorise_nearly_definite(problem);
    if (!sigma) return false;
    const auto v = curvature_.find_direction(problem, *sigma);
    return goes_on_with(*sigma, v ? leave_along(*v) : take_shifted());
  }

  bool may_fall_back() {
    const bool has_fallen_back_here = fell_back_at_ && *fell_back_at_ == iterate_.count();
    return damping_ != 0 && !has_fallen_back_here && iterate_.is_conservative() &&
           iterate_.problem().symmetric();
  }

  bool goes_on_with(double damping, bool has_moved) {
    if (has_moved) damping_ = damping;
    return has_moved;
  }

  bool take_undamped() {
    solve_for_step();
    return static_cast<bool>(rules_.take_newton_step(iterate_, step_));
  }

  bool take_shifted() {
    solve_for_step();
    return static_cast<bool>(rules_.take_by_slope(iterate_, step_));
  }

  void solve_for_step() {
    step_.resize(iterate_.size());
    iterate_.solve(step_);
  }

  Iterate iterate_;
  std::vector<double> step_;  // of fall_back; reserved
  NegativeCurvature curvature_;
  Directions directions_;
  StepRules rules_;
  const Newton::Parameters& p_;
  const double end_;  // least damping
  double damping_;
  std::optional<std::size_t> fell_back_at_;  // count of points
};

}  // namespace

Outcome solve_globalised(const Newton::Parameters& parameters, Problem& problem) {
  // Whether an unsymmetric K curves downwards is not known: it begins with as much as half of its digits.
  Newton::Parameters own = parameters;
  if (!problem.symmetric()) own.least_damping = kShortest;
  return Globalised(own, problem).run();
}

}  // namespace netloft::newton
