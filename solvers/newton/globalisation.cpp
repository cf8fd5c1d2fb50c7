// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/newton/globalisation.hpp"

#include <cmath>

namespace netloft::newton {

namespace {

// Round-offs by which a step may go uphill by (7).
constexpr double kRoundOffs = 10;
// A straight step that ends before the first of these is compared with a curved one. Where it fails, second
// derivatives are found by residuals so near. A curved step must gain so many times what the straight one
// does.
constexpr double kShort = 0.9, kNear = 1e-2, kCurvedGain = 1.5;
// Newton's own step is accepted at once where it leaves so much of the residual.
constexpr double kHalved = 0.5;
// So many steps in a row that promise no less to gain than before: (7) leads nowhere.
constexpr int kStalled = 5;

}  // namespace

std::span<const double> CurvedStep::find(Iterate& iterate, std::span<const double> s, double t) {
  second_derivative_.assign(s.size(), 0.0), a_.resize(s.size());
  for (const double side : {t, -t}) {
    const auto r = iterate.residual_at({s}, side);
    if (!r) return {};
    for (std::size_t i = 0; i < s.size(); ++i)
      second_derivative_[i] += (iterate.residual()[i] - (*r)[i]) / (t * t);
  }
  iterate.problem().solve(second_derivative_, a_);
  return a_;
}

Step Globalisation::take(Iterate& iterate, const Direction& direction) {
  const Path path{direction.s};
  if (-iterate.slope(path) <= iterate.round_off(path)) return take_at_round_off(iterate, direction);
  const Step step = take_by_energy(iterate, direction);
  if (step) forget_gains();
  return step;
}

Step Globalisation::take_at_round_off(Iterate& iterate, const Direction& direction) {
  Step step;
  if (iterate.try_move_if_residual_below(1, {direction.s}, 1))
    step = {Step::Rule::residual, 1};
  else if (direction.damping == 0)
    step = take_by_slope(iterate, direction.s);
  step.is_at_round_off = true;
  return step;
}

Step Globalisation::take_newton_step(Iterate& iterate, std::span<const double> s) {
  if (iterate.problem().step_length(s) <= 1 && iterate.try_move_if_residual_below(kHalved, {s}, 1))
    return {Step::Rule::residual, 1};
  return take_by_slope(iterate, s);
}

Step Globalisation::take_by_slope(Iterate& iterate, std::span<const double> s) {
  const Path path{s};
  const Sample first{0, iterate.energy(), iterate.slope(path)};
  if (!iterate.is_conservative() || first.slope >= 0 || has_stalled(-first.slope)) return {};
  const SlopeSearch search{.noise = kRoundOffs * kEnergyRoundOff * std::abs(iterate.energy())};
  const auto found = search([&](double t) { return iterate.merit(path, t); }, first);
  if (!found || !iterate.try_move(path, found->t)) return {};
  return {Step::Rule::slope, found->t};
}

/// (5), (4), and where (4) ends short, (8), too, if that gains much more.
Step Globalisation::take_by_energy(Iterate& iterate, const Direction& direction) {
  Path path{direction.s};
  const LineSearch search{.decrease = p_.decrease, .flatness = p_.flatness, .shortest = p_.shortest_step};
  const Sample first{0, iterate.energy(), iterate.slope(path)};
  const auto along = [&](const Path& some) {
    return search([&](double t) { return iterate.merit(some, t); }, first);
  };
  auto found = find_whole_uphill(iterate, path);
  if (!found) found = along(path);
  if (!(found && found->t > kShort) && iterate.is_conservative() && iterate.problem().symmetric()) {
    const Path curved{direction.s, curved_.find(iterate, direction.s, found ? found->t : kNear)};
    const auto bent = curved.a.empty() ? std::nullopt : along(curved);
    const double gain = found ? iterate.energy() - found->value : 0;
    if (bent && (!found || iterate.energy() - bent->value > kCurvedGain * gain)) path = curved, found = bent;
  }
  // Tolerances are a part of the last reactions evaluated. A force without an energy may have no value at t.
  if (!found) iterate.evaluate(Matrix::none);
  if (!found || !iterate.try_move(path, found->t)) return {};
  return {Step::Rule::energy, found->t};
}

/// (5): a whole step, if m falls or the last step did not go uphill.
std::optional<Sample> Globalisation::find_whole_uphill(Iterate& iterate, const Path& path) {
  const auto whole = last_was_uphill_ ? std::nullopt : iterate.merit(path, 1);
  const double most = iterate.energy() - p_.uphill * iterate.slope(path);
  last_was_uphill_ = whole && whole->value > iterate.energy() && whole->value <= most;
  return whole && (last_was_uphill_ || whole->value <= iterate.energy()) ? whole : std::nullopt;
}

/// Whether what Newton's steps promise to gain has not halved for so long.
bool Globalisation::has_stalled(double gain) {
  const bool is_less = gain < 0.5 * least_gain_;
  if (is_less) least_gain_ = gain;
  times_no_less_ = is_less ? 0 : times_no_less_ + 1;
  return times_no_less_ > kStalled;
}

void Globalisation::forget_gains() {
  least_gain_ = std::numeric_limits<double>::infinity(), times_no_less_ = 0;
}

}  // namespace netloft::newton
