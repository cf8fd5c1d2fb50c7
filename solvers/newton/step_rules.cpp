// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/newton/step_rules.hpp"

#include <cmath>

namespace netloft::newton {

std::span<const double> CurvedStep::find(Iterate& iterate, std::span<const double> s, double t) {
  minus_second_derivative_.assign(s.size(), 0.0), a_.resize(s.size());
  for (const double side : {t, -t}) {
    const auto r = iterate.residual_at({s}, side);
    if (!r) return {};
    for (std::size_t i = 0; i < s.size(); ++i)
      minus_second_derivative_[i] += (iterate.residual()[i] - (*r)[i]) / (t * t);
  }
  iterate.problem().solve(minus_second_derivative_, a_);
  return a_;
}

Step StepRules::take(Iterate& iterate, const Direction& direction) {
  const Path path{direction.s};
  if (-iterate.slope(path) <= iterate.round_off(path)) return take_at_round_off(iterate, direction);
  const Step step = take_by_energy(iterate, direction);
  if (step) reset_stall_count();
  return step;
}

Step StepRules::take_at_round_off(Iterate& iterate, const Direction& direction) {
  Step step;
  if (iterate.try_move_if_residual_below({direction.s}, 1))
    step = {Step::Rule::residual, 1};
  else if (direction.damping == 0)
    step = take_by_slope(iterate, direction.s);
  step.is_at_round_off = true;
  return step;
}

Step StepRules::take_newton_step(Iterate& iterate, std::span<const double> s) {
  if (iterate.problem().step_length(s) <= 1 && iterate.try_move_if_residual_below({s}, 1))
    return {Step::Rule::residual, 1};
  return take_by_slope(iterate, s);
}

Step StepRules::take_by_slope(Iterate& iterate, std::span<const double> s) {
  const Path path{s};
  const Sample first{0, iterate.energy(), iterate.slope(path)};
  if (!iterate.is_conservative() || first.slope >= 0) return {};
  record_predicted_decrease(-first.slope);
  if (has_stalled()) return {};
  const SlopeSearch search{.noise = kEnergyRoundOff * std::abs(iterate.energy()),
                           .flatness = p_.flatness,
                           .refinement = refinement_of(p_)};
  const auto found = search([&](double t) { return iterate.merit(path, t); }, first);
  if (!found || !iterate.try_move(path, found->t)) return {};
  return {Step::Rule::slope, found->t};
}

/// (5), (4), and where (4) ends short, (8), too, if that gains much more.
Step StepRules::take_by_energy(Iterate& iterate, const Direction& direction) {
  Path path{direction.s};
  const LineSearch search{.flatness = p_.flatness, .refinement = refinement_of(p_)};
  const Sample first{0, iterate.energy(), iterate.slope(path)};
  const auto along = [&](const Path& some) {
    return search([&](double t) { return iterate.merit(some, t); }, first);
  };
  auto found = try_whole_step(iterate, path);
  last_went_uphill_ = found && found->value > iterate.energy();
  if (!found) found = along(path);
  const bool is_whole = found && found->t == 1;
  if (!is_whole && iterate.is_conservative() && iterate.problem().symmetric()) {
    const Path curved{direction.s, curved_.find(iterate, direction.s, found ? found->t : kDifference)};
    const auto bent = curved.a.empty() ? std::nullopt : along(curved);
    if (bent && (!found || bent->value < found->value)) path = curved, found = bent;
  }
  // The host measures by its last evaluation, which was at a trial point: back to u, which is not left.
  if (!found) iterate.evaluate(Matrix::none);
  if (!found || !iterate.try_move(path, found->t)) return {};
  return {Step::Rule::energy, found->t};
}

/// (5): a whole step that lowers m, or raises it by no more than `uphill` allows. The step after one that
/// went uphill is left to the line search.
std::optional<Sample> StepRules::try_whole_step(Iterate& iterate, const Path& path) const {
  if (last_went_uphill_) return {};
  const double most = iterate.energy() - p_.uphill * iterate.slope(path);
  const auto whole = iterate.merit(path, 1);
  return whole && whole->value <= most ? whole : std::nullopt;
}

/// −r·s is what a step s would lower a linear energy by. It has to halve within as many steps as a search may
/// spend on one, or the steps go round in rounding.
void StepRules::record_predicted_decrease(double decrease) {
  const bool has_halved = decrease < 0.5 * least_decrease_;
  if (has_halved) least_decrease_ = decrease;
  steps_without_halving_ = has_halved ? 0 : steps_without_halving_ + 1;
}

bool StepRules::has_stalled() const { return steps_without_halving_ > p_.refinements; }

void StepRules::reset_stall_count() {
  least_decrease_ = std::numeric_limits<double>::infinity(), steps_without_halving_ = 0;
}

}  // namespace netloft::newton
