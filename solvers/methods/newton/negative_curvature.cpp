// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/negative_curvature.hpp"

#include <cmath>

#include "solvers/methods/newton/descent_search.hpp"

namespace netloft::newton {

NegativeCurvature::NegativeCurvature(const Newton::Parameters& parameters, const Problem& problem)
    : p_(parameters), curvature_(problem.symmetric() ? problem.size() : 0) {
  downhill_.reserve(problem.size());
}

std::optional<std::span<const double>> NegativeCurvature::find_direction(Problem& problem, double sigma) {
  if (!(curvature_.find(problem, sigma) < 0)) return {};
  return curvature_.direction();
}

bool NegativeCurvature::leave_along(std::span<const double> v, Iterate& iterate) {
  downhill_.assign(v.begin(), v.end());
  const double one_element = (iterate.slope({v}) > 0 ? -1 : 1) / iterate.problem().step_length(v);
  for (double& x : downhill_) x *= one_element;
  const Path path{downhill_};
  const auto found = DescentSearch{refinement_of(p_)}([&](double t) { return iterate.merit(path, t); },
                                                      {0, iterate.energy(), iterate.slope(path)},
                                                      kEnergyRoundOff * std::abs(iterate.energy()));
  return found && iterate.try_move(path, found->t);
}

}  // namespace netloft::newton
