// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/timed_trial.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/march.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

namespace netloft::studies {

namespace {

Trial trial_of(Solution&& s, double tolerance) {
  Trial t;
  t.tolerance = tolerance;
  t.status = s.status;
  t.stability = s.stability;
  t.reason = std::move(s.reason);
  t.cpu_seconds = s.cost.statistics.solver_cpu_seconds;
  t.statistics = s.cost.statistics;
  t.residual = s.balance.residual;
  t.load = s.balance.scale;
  t.estimate = s.correction.length;
  t.energy = s.energy;
  t.x = std::move(s.x);
  t.u = std::move(s.u);
  return t;
}

const char* word_for(MarchStatus status) {
  switch (status) {
    case MarchStatus::finished:
      return "finished";
    case MarchStatus::interrupted:
      return "interrupted";
    case MarchStatus::out_of_time:
      return "out of time";
    case MarchStatus::out_of_work:
      return "out of work";
    default:
      return "lost";
  }
}

/// Computes one motion. The positions at all outputs stay in memory; no file is written.
Trial trial_in_time(runs::PreparedScene& fresh, const Method& method, double tolerance,
                    const runs::Watch& watch) {
  Trial t;
  MarchWatch look;
  const std::string name = fmt::format("{} at {:.0e}", method.name(), tolerance);
  look.on_step = [&](const StepRecord& step, std::span<const double>) {
    if (watch.on_step) watch.on_step(step, name);
    return false;
  };
  look.on_output = [&t](const Snapshot& at) { t.path.emplace_back(at.x.begin(), at.x.end()); };
  MarchResult result = runs::march(fresh, look, watch, nullptr, fresh.loaded().analysis.work);
  t.tolerance = tolerance;
  t.reason = std::move(result.reason);
  t.of_motion = word_for(result.status);
  t.status = result.status == MarchStatus::finished ? SolveStatus::converged : SolveStatus::not_converged;
  t.cpu_seconds = result.statistics.total_cpu_seconds;
  t.statistics = result.statistics;
  t.steps = result.steps;
  t.rejected = result.rejected;
  t.is_damped = !fresh.material_damping().starts_with("off: ");
  return t;
}

/// A trial in which the plugin broke down. Trials at other tolerances may still succeed.
Trial failed_trial(double tolerance, const std::string& why) {
  Trial t;
  t.tolerance = tolerance;
  t.failed = true;
  t.reason = why;
  t.cpu_seconds = std::numeric_limits<double>::quiet_NaN();
  return t;
}

Trial run_once(const runs::CaseSource& source, Registry& registry, const Method& method, double tolerance,
               const runs::Watch& watch) {
  runs::PreparedScene fresh(source_for(source, method, tolerance), registry);
  if (fresh.prepare() != runs::PreparedScene::State::ready)
    throw std::runtime_error(method.specification + ": " + fresh.diagnostics().render(false));
  try {
    if (method.kind() == "integrator") return trial_in_time(fresh, method, tolerance, watch);
    return trial_of(runs::find_equilibrium(fresh, watch), tolerance);
  } catch (const PluginRefused&) {
    throw;
  } catch (const std::runtime_error& e) {
    return failed_trial(tolerance, e.what());
  }
}

Trial not_tried(double tolerance) {
  Trial t;
  t.tolerance = tolerance;
  t.tried = false;
  t.reason = "the method did not reach a looser tolerance";
  return t;
}

}  // namespace

std::string Method::kind() const {
  for (const char* word : {"strategy", "integrator"})
    if (specification.starts_with(std::string(word) + " ")) return word;
  return "solver";
}

std::string Method::name() const {
  return kind() == "solver" ? specification : specification.substr(kind().size() + 1);
}

runs::CaseSource source_for(const runs::CaseSource& source, const Method& method, double tolerance) {
  runs::CaseSource with = source;
  formats::append(with.changes, runs::choose_method(method.kind(), method.name()));
  with.changes.push_back(formats::make_change(
      {"analysis", method.kind() == "integrator" ? "accuracy" : "tolerance"}, {{}, tolerance}));
  return with;
}

Trial run_trial(const runs::CaseSource& source, Registry& registry, const Method& method, double tolerance,
                int repeats, const runs::Watch& watch) {
  Trial best = run_once(source, registry, method, tolerance, watch);
  for (int i = 1; i < repeats && best.converged(); ++i) {
    Trial again = run_once(source, registry, method, tolerance, watch);
    if (again.converged() && again.cpu_seconds < best.cpu_seconds) best = std::move(again);
  }
  return best;
}

std::vector<Trial> run_trials(const runs::CaseSource& source, Registry& registry, const Method& method,
                              const std::vector<double>& tolerances, int repeats, const runs::Watch& watch) {
  std::vector<Trial> trials;
  for (const double tolerance : tolerances)
    trials.push_back(trials.empty() || trials.back().converged() || method.kind() == "integrator"
                         ? run_trial(source, registry, method, tolerance, repeats, watch)
                         : not_tried(tolerance));
  return trials;
}

}  // namespace netloft::studies
