// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/newton/negative_curvature.hpp"

#include <netloft/imbalance.hpp>

#include <algorithm>
#include <cmath>

#include "solvers/newton/descent_search.hpp"

namespace netloft::newton {

NegativeCurvature::NegativeCurvature(const Newton::Parameters& parameters, const Problem& problem)
    : p_(parameters), sigma_(parameters.least_damping), curvature_(problem.symmetric() ? problem.size() : 0) {
  downhill_.reserve(problem.size());
}

/// From one below that of the last time, by `factor`.
std::optional<double> NegativeCurvature::factorise_nearly_definite(Problem& problem) {
  for (sigma_ = std::max(p_.least_damping, sigma_ / p_.factor); sigma_ <= kMatters * (1 + kShortest);
       sigma_ *= p_.factor)
    if (problem.factorise(Matrix::exact, sigma_) == Factor::ok) return sigma_;
  sigma_ = p_.least_damping;
  return {};
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
