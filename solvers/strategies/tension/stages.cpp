// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/stages.hpp"

#include <algorithm>
#include <limits>

namespace netloft::tension {

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

}  // namespace

Stages::Stages(const Parameters& parameters, netloft_members& members)
    : p_(parameters), parts_(members.parts), newton_(parameters, members) {}

MixedNewton::Ending Stages::solve(std::span<double> u) {
  using Ending = MixedNewton::Ending;
  Ending ending = newton_.solve(soft_stage(), u);
  if (ending != Ending::converged) return ending;
  for (double multiple = p_.ratio; multiple < p_.last && ending != Ending::called_off; multiple *= p_.ratio)
    ending = newton_.solve(next_stage(multiple), u);
  return ending == Ending::called_off ? ending : newton_.solve(last_stage(), u);
}

MixedNewton::Stage Stages::soft_stage() const {
  return {.name = "soft",
          .factor = std::vector<double>(parts_, p_.softest),
          .is_far = true,
          .damping = MixedNewton::kMostDamping,
          .farthest_turn = kNoLimit,
          .tolerance = p_.tolerance,
          .iterations = p_.iterations};
}

/// Returns a stage in which the stiffness of every part is at most a multiple of its tension.
MixedNewton::Stage Stages::next_stage(double multiple) const {
  const std::vector<double> tension = newton_.tensions_by_part(), stiffness = newton_.stiffness_by_part();
  const double least = largest_of(tension) / p_.last;
  std::vector<double> factor(parts_, 1.0);
  for (std::size_t p = 0; p < parts_; ++p)
    if (stiffness[p] > 0) factor[p] = std::min(1.0, multiple * std::max(tension[p], least) / stiffness[p]);
  return {.name = "stiffer",
          .factor = std::move(factor),
          .damping = p_.damping,
          .farthest_turn = p_.turn,
          .is_between = true,
          .iterations = p_.iterations};
}

MixedNewton::Stage Stages::last_stage() const {
  return {.name = "as it is",
          .factor = std::vector<double>(parts_, 1.0),
          .damping = p_.damping,
          .farthest_turn = p_.turn,
          .tolerance = kOnlyAStart,
          .iterations = p_.iterations};
}

}  // namespace netloft::tension
