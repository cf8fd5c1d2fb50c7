// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/newton/negative_curvature.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/newton/descent_search.hpp"

namespace netloft::newton {

namespace {

// K is nearly definite where a σ between these makes it positive definite.
constexpr double kLeastSigma = 1e-7, kMostSigma = 1e-4;

}  // namespace

NegativeCurvature::NegativeCurvature(const Problem& problem)
    : sigma_(kLeastSigma), curvature_(problem.symmetric() ? problem.size() : 0) {
  downhill_.reserve(problem.size());
}

/// By decades, from the one below that of the last time.
std::optional<double> NegativeCurvature::factorise_nearly_definite(Problem& problem) {
  for (sigma_ = std::max(kLeastSigma, 0.1 * sigma_); sigma_ < 2 * kMostSigma; sigma_ *= 10)
    if (problem.factorise(Matrix::exact, sigma_) == Factor::ok) return sigma_;
  sigma_ = kLeastSigma;
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
  const auto found = DescentSearch{}([&](double t) { return iterate.merit(path, t); },
                                     {0, iterate.energy(), iterate.slope(path)},
                                     kEnergyRoundOff * std::abs(iterate.energy()));
  return found && iterate.try_move(path, found->t);
}

}  // namespace netloft::newton
