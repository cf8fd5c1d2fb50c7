// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/newton/globalisation.hpp"

namespace netloft::newton {

/// Where the step promises to gain less than rounding of the energy, by the residual.
Step Globalisation::take(Iterate& iterate, const Direction& direction) {
  if (-iterate.slope(direction.s) > iterate.round_off(direction.s)) return take_by_energy(iterate, direction);
  if (!iterate.try_move_if_residual_falls(direction.s, 1)) return {};
  return {Step::Rule::residual, 1};
}

/// (5), and where that does not hold, (4).
Step Globalisation::take_by_energy(Iterate& iterate, const Direction& direction) {
  const std::span<const double> s = direction.s;
  const Sample first{0, iterate.energy(), iterate.slope(s)};
  auto found = try_whole_step(iterate, s);
  last_went_uphill_ = found && found->value > iterate.energy();
  if (!found)
    found = LineSearch{.flatness = p_.flatness}([&](double t) { return iterate.merit(s, t); }, first);
  // Tolerances are a part of the last reactions evaluated. A force without an energy may have no value at t.
  if (!found) iterate.evaluate(Matrix::none);
  if (!found || !iterate.try_move(s, found->t)) return {};
  return {Step::Rule::energy, found->t};
}

/// (5): a whole step that lowers m, or raises it by no more than `uphill` allows. The step after one that
/// went uphill is left to the line search.
std::optional<Sample> Globalisation::try_whole_step(Iterate& iterate, std::span<const double> s) const {
  if (last_went_uphill_) return {};
  const double most = iterate.energy() - p_.uphill * iterate.slope(s);
  const auto whole = iterate.merit(s, 1);
  return whole && whole->value <= most ? whole : std::nullopt;
}

}  // namespace netloft::newton
