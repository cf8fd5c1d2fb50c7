// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/perturbed.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::real_gears {

namespace {

/// The least value that this fraction of all values does not exceed; `sorted` is not empty.
int quantile(const std::vector<Effort>& sorted, double fraction) {
  const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(sorted.size())));
  return sorted[std::max<std::size_t>(rank, 1) - 1].factorisations;
}

}  // namespace

std::vector<Start> starts_of(const PerturbedDrawings& drawings) {
  std::vector<Start> starts(1);
  for (int i = 0; i < drawings.count; ++i) {
    const double along = drawings.count > 1 ? i / (drawings.count - 1.0) : 0;
    starts.push_back({.noise = drawings.least * std::pow(drawings.largest / drawings.least, along),
                      .seed = drawings.seed + static_cast<std::uint64_t>(i)});
  }
  return starts;
}

Reliability summarise(std::vector<Effort> efforts) {
  if (efforts.empty()) return {};
  std::sort(efforts.begin(), efforts.end(),
            [](const Effort& a, const Effort& b) { return a.factorisations < b.factorisations; });
  const auto converged =
      std::count_if(efforts.begin(), efforts.end(), [](const Effort& e) { return e.converged; });
  return {efforts.size(), static_cast<std::size_t>(converged), quantile(efforts, 0.5),
          quantile(efforts, 0.95)};
}

Reliability solve_perturbed(const NeutralCase& gear, const Modelling& modelling,
                            const PerturbedDrawings& drawings, const test::Solving& how) {
  std::vector<Effort> efforts;
  for (const Start& start : starts_of(drawings)) {
    const Solution s = solve_by_strategy(gear, modelling, start, how).solved.solution;
    efforts.push_back({s.status == SolveStatus::converged, s.cost.statistics.factorisations});
  }
  return summarise(std::move(efforts));
}

}  // namespace netloft::real_gears
