// SPDX-License-Identifier: BSD-3-Clause
#include "framework/study/study_host.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace netloft {

namespace {

/// A solver that returns at once: what is judged is its start.
const SolverType& no_solver() {
  static const SolverType type = [] {
    SolverType none;
    none.type = "none";
    none.solver.size = sizeof none.solver, none.solver.name = "none", none.solver.doc = "judges a point";
    none.solver.solve = [](const void*, netloft_problem*) -> int { return NETLOFT_STOPPED; };
    return none;
  }();
  return type;
}

ParameterBlock block_of(const SolverUse& use) {
  std::vector<std::string> faults;
  ParameterBlock block(use.type->parameters, use.type->solver.parameter_bytes, use.parameters, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  return block;
}

}  // namespace

StudyHost::StudyHost(const SiteSource& source, const StudyOptions& options)
    : options_(options), sites_(source), begun_(cpu_seconds()) {}

double StudyHost::seconds_left() const {
  return std::max(0.0, options_.limits.seconds - (cpu_seconds() - begun_));
}

bool StudyHost::is_interrupted() const {
  return (options_.limits.interrupt && options_.limits.interrupt->load()) || seconds_left() == 0;
}

SolverUse StudyHost::solver_of(const netloft_stage& stage) const {
  SolverUse use = options_.solver;
  if (stage.solver) {
    use.type = &sites_.source().registry->solver(stage.solver);
    use.parameters = given_of(use.type->type);
  }
  if (stage.parameters)
    use.parameters.merge(parse_parameters(use.type->parameters, stage.parameters));  // the user's own hold
  return use;
}

Values StudyHost::given_of(const std::string& type) const {
  const auto given = options_.given.find(type);
  return given == options_.given.end() ? Values{} : given->second;
}

Limits StudyHost::limits_of(const netloft_stage& stage, const Site& site) {
  Limits limits = options_.limits;
  limits.tolerance = stage.tolerance;
  if (stage.iterations > 0) limits.iterations = static_cast<int>(stage.iterations);
  if (stage.path > 0) limits.path = stage.path;
  limits.model = &site.model, limits.work = stage.work;
  limits.seconds = seconds_left();
  limits.judging.ask_growth = is_as_written(stage.variant) && stage.tolerance <= options_.limits.tolerance;
  if (limits.judging.ask_growth) limits.judging.known = &judged_;
  return limits;
}

Observer StudyHost::observer_of(const netloft_stage& stage) const {
  return {options_.on_iteration, is_as_written(stage.variant) ? options_.kept : nullptr};
}

Solution StudyHost::solve(const netloft_stage& stage, const SolverUse& solver) {
  const auto site = sites_.at(stage.variant);
  const ParameterBlock parameters = block_of(solver);
  const auto size = static_cast<std::size_t>(site->assembler->pattern().size);
  const StartPoint start{{stage.u, size},
                         stage.flags & NETLOFT_COMPENSATED ? Positions::compensated : Positions::plain};
  Solution s =
      solve_static({*site->scene, *site->assembler, sites_.source().make}, {solver.type, parameters.data()},
                   limits_of(stage, *site), start, observer_of(stage));
  record({stage.name, solver.type->type, size, s.status, s.reason, s.cost.statistics, stage.variant,
          site->model.of(s.judging)},
         *site);
  if (options_.on_stage && !s.u.empty()) {
    const auto moved = stage.variant.level ? sites_.transfer(stage.variant.level, s.u, 0) : s.u;
    if (!moved.empty()) options_.on_stage(cost_.stages.back(), moved);
  }
  return s;
}

Solution StudyHost::assess(const netloft_stage& stage) { return solve(stage, {&no_solver(), {}}); }

void StudyHost::record(StageRecord stage, const Site& site) {
  stage.work += site.model.of(stage.statistics);
  cost_.statistics.add(stage.statistics), cost_.work += stage.work;
  cost_.stages.push_back(std::move(stage));
}

Solution StudyHost::finish(Solution solution) const {
  solution.cost = cost_;
  return solution;
}

}  // namespace netloft
