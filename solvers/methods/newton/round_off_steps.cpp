// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/round_off_steps.hpp"

#include <cmath>

namespace netloft::newton {

bool StallCount::stalls_with(double decrease) {
  const bool has_halved = decrease < 0.5 * least_;
  if (has_halved) least_ = decrease;
  steps_without_halving_ = has_halved ? 0 : steps_without_halving_ + 1;
  return steps_without_halving_ > most_steps_;
}

RoundOffSteps::RoundOffSteps(const Newton::Parameters& parameters, Problem& problem,
                             NearlyDefinite& nearly_definite, NegativeCurvature& curvature)
    : p_(parameters),
      nearly_definite_(nearly_definite),
      curvature_(curvature),
      stall_(parameters.refinements) {
  s_.reserve(problem.size());
}

Step RoundOffSteps::take(Iterate& iterate, const Direction& direction) {
  if (iterate.try_move_if_residual_below({direction.s}, 1))
    return {Step::Rule::residual, direction.damping, 1};
  if (direction.damping != 0) return {.damping = direction.damping};
  return take_by_slope(iterate, direction.s, 0);
}

Step RoundOffSteps::fall_back(Iterate& iterate, double damping) {
  if (!may_fall_back(iterate, damping)) return {.damping = damping};
  fell_back_at_ = iterate.count();
  Step step = take_with_another_matrix(iterate);
  if (!step) step.damping = damping;
  return step;
}

/// Tries a step by the undamped tangent K or, if K is only nearly definite, by K + σ M.
Step RoundOffSteps::take_with_another_matrix(Iterate& iterate) {
  Problem& problem = iterate.problem();
  if (problem.factorise(Matrix::exact, 0) == Factor::ok) return take_newton_step(iterate);
  if (!iterate.is_conservative()) return {};
  const auto sigma = nearly_definite_.factorise(problem);
  if (!sigma) return {};
  const auto v = curvature_.find_direction(problem, *sigma);
  if (!v) return take_by_slope(iterate, solve(iterate), *sigma);
  return {.damping = *sigma, .leaves_saddle = curvature_.leave_along(*v, iterate)};
}

bool RoundOffSteps::may_fall_back(Iterate& iterate, double damping) const {
  const bool has_fallen_back_here = fell_back_at_ && *fell_back_at_ == iterate.count();
  return damping != 0 && !has_fallen_back_here;
}

Step RoundOffSteps::take_newton_step(Iterate& iterate) {
  const auto s = solve(iterate);
  if (iterate.problem().step_length(s) <= 1 && iterate.try_move_if_residual_below({s}, 1))
    return {Step::Rule::residual, 0, 1};
  return take_by_slope(iterate, s, 0);
}

/// Tries (7) of newton.hpp along s. It uses the slope, which still has significant digits when changes of the
/// energy have none.
Step RoundOffSteps::take_by_slope(Iterate& iterate, std::span<const double> s, double damping) {
  const Step none{.damping = damping};
  const Path path{s};
  const Sample first{0, iterate.energy(), iterate.slope(path)};
  if (first.slope >= 0 || stall_.stalls_with(-first.slope)) return none;
  const SlopeSearch search{
      .noise = iterate.round_off(path), .flatness = p_.flatness, .refinement = refinement_of(p_)};
  const auto found = search([&](double t) { return iterate.merit(path, t); }, first);
  if (!found || !iterate.try_move(path, found->t)) return none;
  return {Step::Rule::slope, damping, found->t};
}

std::span<const double> RoundOffSteps::solve(Iterate& iterate) {
  s_.resize(iterate.size());
  iterate.solve(s_);
  return s_;
}

}  // namespace netloft::newton
