// SPDX-License-Identifier: BSD-3-Clause
#include "framework/study/study.hpp"

#include "framework/registry/plugin_call.hpp"
#include "framework/study/study_host.hpp"

#include <cassert>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace netloft {

namespace {

ParameterBlock block_of(const StrategyUse& use) {
  std::vector<std::string> faults;
  ParameterBlock block(use.type->parameters, use.type->strategy.parameter_bytes, use.parameters, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  return block;
}

/// What a strategy leaves that solved no stage of the scene: the start, judged, with the reason. Whoever
/// shows a solution needs a place for every node.
Solution at_start(StudyHost& host, const netloft_study& study, Solution none) {
  std::vector<double> u(study.unknowns, 0.0);
  if (study.start) u.assign(study.start, study.start + study.unknowns);
  netloft_stage stage{};
  stage.size = sizeof stage, stage.variant = as_written(), stage.name = "the start", stage.u = u.data();
  stage.tolerance = host.options().limits.tolerance, stage.work = host.options().work;
  Solution start = host.assess(stage);
  start.status = SolveStatus::not_converged, start.reason = std::move(none.reason);
  start.does_not_settle = none.does_not_settle, start.stages = std::move(none.stages);
  start.statistics = none.statistics, start.work = none.work;
  return start;
}

}  // namespace

Solution find_equilibrium(const SiteSource& source, const StudyOptions& options, const StrategyUse& strategy,
                          const std::vector<double>& start) {
  StudyHost host(source, options);
  const ParameterBlock parameters = block_of(strategy);
  RunningStudy study(host, as_written(), options.limits.tolerance, options.work,
                     start.empty() ? nullptr : start.data());
  study.run(*strategy.type, parameters.data());
  Solution best = host.finish(study.best());
  if (!study.has_any()) best = at_start(host, study.interface(), std::move(best));
  if (best.status == SolveStatus::converged) source.assembler->remember(best.x);
  return best;
}

std::string explain_strategy(const SiteSource& source, const StudyOptions& options,
                             const StrategyUse& strategy) {
  if (!strategy.type->strategy.explain) return "";
  StudyHost host(source, options);
  const ParameterBlock parameters = block_of(strategy);
  RunningStudy study(host, as_written(), options.limits.tolerance, options.work, nullptr);
  std::string text(4096, '\0');
  const PluginCall call({strategy.type->type.c_str(), "explain", nullptr, CallFrame::Kind::method});
  const int status = strategy.type->strategy.explain(parameters.data(), &study.interface(), text.data(),
                                                     static_cast<std::uint32_t>(text.size()));
  text.resize(status == NETLOFT_OK ? text.find('\0') : 0);
  return text;
}

}  // namespace netloft
