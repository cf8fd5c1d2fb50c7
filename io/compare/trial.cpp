// SPDX-License-Identifier: BSD-3-Clause
#include "io/compare/trial.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace netloft::io {

namespace {

Trial trial_of(Solution&& s, double tolerance) {
  Trial t;
  t.tolerance = tolerance;
  t.status = s.status, t.stability = s.stability, t.reason = std::move(s.reason);
  t.cpu_seconds = s.statistics.solver_cpu_seconds, t.statistics = s.statistics;
  t.residual = s.balance.residual, t.load = s.balance.scale;
  t.estimate = s.correction, t.energy = s.energy;
  t.x = std::move(s.x), t.u = std::move(s.u);
  return t;
}

Trial run_once(const CaseSource& source, Registry& registry, const Method& method, double tolerance,
               const Watch& watch) {
  Case fresh(source_for(source, method, tolerance), registry);
  if (fresh.open() != Case::State::ready)
    throw std::runtime_error(method.specification + ": " + fresh.diagnostics().render(false));
  return trial_of(fresh.solve(watch), tolerance);
}

Trial not_tried(double tolerance) {
  Trial t;
  t.tolerance = tolerance, t.tried = false, t.reason = "a looser tolerance was not reached";
  return t;
}

}  // namespace

CaseSource source_for(const CaseSource& source, const Method& method, double tolerance) {
  CaseSource with = source;
  constexpr std::string_view kStrategyPrefix = "strategy ";
  const bool is_strategy = method.specification.starts_with(kStrategyPrefix);
  const auto overrides = is_strategy
                             ? overrides_of("strategy", method.specification.substr(kStrategyPrefix.size()))
                             : overrides_of("solver", method.specification);
  with.overrides.insert(with.overrides.end(), overrides.begin(), overrides.end());
  with.overrides.push_back(fmt::format("analysis.tolerance={:e}", tolerance));
  return with;
}

Trial run_trial(const CaseSource& source, Registry& registry, const Method& method, double tolerance,
                int repeats, const Watch& watch) {
  Trial best = run_once(source, registry, method, tolerance, watch);
  for (int i = 1; i < repeats && best.converged(); ++i) {
    Trial again = run_once(source, registry, method, tolerance, watch);
    if (again.converged() && again.cpu_seconds < best.cpu_seconds) best = std::move(again);
  }
  return best;
}

std::vector<Trial> run_trials(const CaseSource& source, Registry& registry, const Method& method,
                              const std::vector<double>& tolerances, int repeats, const Watch& watch) {
  std::vector<Trial> trials;
  for (const double tolerance : tolerances)
    trials.push_back(trials.empty() || trials.back().converged()
                         ? run_trial(source, registry, method, tolerance, repeats, watch)
                         : not_tried(tolerance));
  return trials;
}

}  // namespace netloft::io
