// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/merit_steps.hpp"

namespace netloft::newton {

std::span<const double> CurvedStep::find(Iterate& iterate, std::span<const double> s, double t) {
  minus_second_derivative_.assign(s.size(), 0.0);
  a_.resize(s.size());
  for (const double side : {t, -t}) {
    const auto r = iterate.residual_at({s}, side);
    if (!r) return {};
    for (std::size_t i = 0; i < s.size(); ++i)
      minus_second_derivative_[i] += (iterate.residual()[i] - (*r)[i]) / (t * t);
  }
  iterate.problem().solve(minus_second_derivative_, a_);
  return a_;
}

Step MeritSteps::take(Iterate& iterate, const Direction& direction) {
  Path path{direction.s};
  const LineSearch search{.flatness = p_.flatness, .refinement = refinement_of(p_)};
  const Sample first{0, iterate.energy(), iterate.slope(path)};
  const auto along = [&](const Path& some) {
    return search([&](double t) { return iterate.merit(some, t); }, first);
  };
  auto found = try_whole_step(iterate, path);
  if (!found) found = along(path);
  const bool is_whole = found && found->t == 1;
  if (!is_whole && iterate.is_conservative() && iterate.problem().symmetric()) {
    const Path curved{direction.s, curved_.find(iterate, direction.s, found ? found->t : kDifference)};
    const auto bent = curved.a.empty() ? std::nullopt : along(curved);
    if (bent && (!found || bent->value < found->value)) {
      path = curved;
      found = bent;
    }
  }
  if (!found || !iterate.try_move(path, found->t)) return {.damping = direction.damping};
  add_gain(first.value - found->value);
  return {Step::Rule::energy, direction.damping, found->t};
}

/// Tries (5) of newton.hpp: a whole step that lowers m, or raises it by no more than `uphill` allows if m is
/// as low as it has ever been. Steps longer than an element are left to the line search.
std::optional<Sample> MeritSteps::try_whole_step(Iterate& iterate, const Path& path) const {
  if (iterate.problem().step_length(path.s) > 1) return {};
  const double allowed = gained_ < most_gained_ ? 0 : -p_.uphill * iterate.slope(path);
  const double most = iterate.energy() + allowed;
  const auto whole = iterate.merit(path, 1);
  return whole && whole->value <= most ? whole : std::nullopt;
}

}  // namespace netloft::newton
