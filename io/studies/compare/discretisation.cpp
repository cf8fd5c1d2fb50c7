// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/discretisation.hpp"

#include <stdexcept>

namespace netloft::studies {

namespace {

constexpr double kTolerance = 1e-10;  // small enough to keep solver errors well below mesh errors

runs::CaseSource divided(const runs::CaseSource& source, const MeshLevel& level) {
  runs::CaseSource with = source;
  formats::append(with.changes, level.changes);
  return with;
}

MeshResult solve_level(const runs::CaseSource& source, Registry& registry, const Method& method,
                       const MeshLevel& level, const runs::Watch& watch, Places& places) {
  const runs::CaseSource mesh = divided(source, level);
  MeshResult result;
  result.cells = level.cells;
  result.trial = run_trial(mesh, registry, method, kTolerance, 1, watch);
  runs::PreparedScene fresh(source_for(mesh, method, kTolerance), registry);
  if (fresh.prepare() != runs::PreparedScene::State::ready)
    throw std::runtime_error(fresh.diagnostics().render(false));
  result.unknowns = fresh.plan().unknowns;
  if (result.trial.converged())
    places = places_of(fresh.loaded(), fresh.assembler().node_positions(result.trial.x));
  return result;
}

double width(const MeshResult& level) { return 1.0 / static_cast<double>(level.cells); }

/// The order of convergence observed on the meshes i − 2, i − 1 and i.
double order_at(const std::vector<Places>& places, const Discretisation& d, std::size_t i) {
  const Places& among = places[i - 2];
  return observed_order(mean_distance(places[i - 2], places[i - 1], among),
                        mean_distance(places[i - 1], places[i], among), width(d.levels[i - 2]),
                        width(d.levels[i - 1]), width(d.levels[i]));
}

}  // namespace

void judge_meshes(const std::vector<Places>& places, Discretisation& d) {
  const std::size_t n = d.levels.size();
  std::vector<double> orders;
  for (std::size_t i = 2; i < n; ++i) orders.push_back(d.levels[i].order = order_at(places, d, i));
  if (!orders.empty()) d.order = orders.back();
  d.steady = is_steady(std::span(orders).last(std::min<std::size_t>(orders.size(), 2)));
  Places goal = places[n - 1];
  if (d.steady)
    goal = extrapolate(places[n - 1], places[n - 2],
                       extrapolation_weight(d.order, width(d.levels[n - 2]), width(d.levels[n - 1])),
                       places[n - 3]);
  for (std::size_t i = 0; i < n; ++i)
    if (d.steady || i + 1 < n) d.levels[i].error = largest_distance(places[i], goal);
}

Discretisation find_discretisation_error(const runs::CaseSource& source, Registry& registry,
                                         const Method& method, const std::string& part,
                                         const std::vector<MeshLevel>& levels, const runs::Watch& watch) {
  Discretisation result;
  result.part = part;
  std::vector<Places> places;
  bool all_converged = true;
  for (const MeshLevel& level : levels) {
    places.emplace_back();
    result.levels.push_back(solve_level(source, registry, method, level, watch, places.back()));
    all_converged &= result.levels.back().trial.converged();
  }
  if (all_converged) judge_meshes(places, result);
  return result;
}

}  // namespace netloft::studies
