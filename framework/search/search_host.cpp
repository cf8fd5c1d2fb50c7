// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/search_host.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace netloft {

namespace {

/// A solver that returns at once, so that the host can assess a point by the same code as after a solve.
const SolverType& no_solver() {
  static const SolverType type = [] {
    SolverType none;
    none.type = "none";
    none.solver.size = sizeof none.solver;
    none.solver.name = "none";
    none.solver.doc = "judges a point";
    none.solver.solve = [](const void*, netloft_problem*) -> int { return NETLOFT_STOPPED; };
    return none;
  }();
  return type;
}

// How many numbers KnownStages stores at most, per unknown of the scene. They suffice for about ten points on
// the scene's own mesh, and take less memory than a factor of netting. In samples of hard cases of small and
// of medium size, 32 numbers cost 1 % and 2 % more factorisations; 128 and 256 numbers saved at most 3 %.
constexpr std::size_t kNumbersKept = 64;

// Largest depth of nested calls of strategies. Grid sequencing by the strategy `auto` takes two nested calls
// per mesh, and no scene has thirty meshes.
constexpr int kDeepestCall = 64;

bool was_cut_off(const Solution& s) {
  return !is_stationary(s) && (s.run.stop == Stop::work || s.run.stop == Stop::iterations);
}

StageRequest request_of(const netloft_stage& stage, const SolverUse& solver, std::size_t size) {
  return {.by_strategy = false,
          .by = solver.type->type,
          .parameters = solver.parameters,
          .variant = stage.variant,
          .tolerance = stage.tolerance,
          .path = stage.path,
          .iterations = stage.iterations,
          .flags = stage.flags,
          .start = {stage.u, stage.u + size}};
}

ParameterBlock block_of(const SolverUse& use) {
  std::vector<std::string> faults;
  ParameterBlock block(use.type->parameters, use.type->solver.parameter_bytes, use.parameters, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  return block;
}

}  // namespace

SearchHost::SearchHost(const VariantSource& source, const SearchOptions& options)
    : options_(options),
      variant_problems_(source),
      known_(kNumbersKept * static_cast<std::size_t>(source.assembler->pattern().size)),
      begun_(cpu_seconds()) {}

double SearchHost::seconds_left() const {
  return std::max(0.0, options_.limits.seconds - (cpu_seconds() - begun_));
}

bool SearchHost::is_interrupted() const {
  return (options_.limits.interrupt && options_.limits.interrupt->load()) || seconds_left() == 0;
}

SolverUse SearchHost::solver_of(const netloft_stage& stage) const {
  SolverUse use = options_.solver;
  if (stage.solver) {
    use.type = &variant_problems_.source().registry->solver(stage.solver);
    use.parameters = given_of(use.type->type);
  }
  if (stage.parameters)
    use.parameters.merge(
        parse_parameters(use.type->parameters, stage.parameters));  // the user's values prevail
  return use;
}

Values SearchHost::given_of(const std::string& type) const {
  const auto given = options_.given.find(type);
  return given == options_.given.end() ? Values{} : given->second;
}

Limits SearchHost::limits_of(const netloft_stage& stage, const VariantProblem& variant_problem) {
  Limits limits = options_.limits;
  limits.tolerance = stage.tolerance;
  if (stage.iterations > 0) limits.iterations = static_cast<int>(stage.iterations);
  if (stage.path > 0) limits.path = stage.path;
  limits.model = &variant_problem.model;
  limits.work = stage.work;
  limits.seconds = seconds_left();
  limits.judging.examine_growth = options_.limits.judging.examine_growth && is_as_written(stage.variant) &&
                                  stage.tolerance <= options_.limits.tolerance;
  if (limits.judging.examine_growth) limits.judging.known = &judged_;
  return limits;
}

Observer SearchHost::observer_of(const netloft_stage& stage) const {
  return {options_.on_iteration, is_as_written(stage.variant) ? options_.kept : nullptr};
}

const KnownStage* SearchHost::find_known(const StageRequest& request) {
  const KnownStage* known = known_.find(request);
  if (known) repeated_ += variant_problems_.at(as_written())->model.of({.residuals = 1});
  return known;
}

/// Stores a result. An equilibrium of the scene itself is not stored, because it ends the search.
void SearchHost::keep_known(KnownStage stage) {
  const bool is_scene =
      is_as_written(stage.request.variant) && stage.request.tolerance <= options_.limits.tolerance;
  const bool is_found = is_scene && stage.solution.status == SolveStatus::converged;
  const bool is_interrupted = stage.solution.status == SolveStatus::interrupted;
  if (!is_found && !is_interrupted && !stage.solution.u.empty()) known_.keep(std::move(stage));
}

Solution SearchHost::solve(const netloft_stage& stage, const SolverUse& solver) {
  const auto size =
      static_cast<std::size_t>(variant_problems_.find_level(stage.variant.level)->assembler->pattern().size);
  StageRequest request = request_of(stage, solver, size);
  const KnownStage* known = find_known(request);
  if (known && !known->is_cut_off) return known->solution;
  const auto variant_problem = variant_problems_.at(stage.variant);
  const ParameterBlock parameters = block_of(solver);
  const StartPoint start{known ? known->solution.u : request.start,
                         stage.flags & NETLOFT_COMPENSATED ? Positions::compensated : Positions::plain};
  Solution s = solve_static(
      {*variant_problem->scene, *variant_problem->assembler, variant_problems_.source().make},
      {solver.type, parameters.data()}, limits_of(stage, *variant_problem), start, observer_of(stage));
  record({stage.name, solver.type->type, size, s.status, s.reason, s.cost.statistics, stage.variant,
          variant_problem->model.of(s.judging)},
         *variant_problem);
  // A request without a solver only assesses a point at next to no cost. Its result is not stored.
  if (solver.type != &no_solver())
    keep_known({.request = std::move(request), .solution = s, .is_cut_off = was_cut_off(s)});
  if (options_.on_stage && !s.u.empty()) {
    const auto moved = stage.variant.level ? variant_problems_.transfer(stage.variant.level, s.u, 0) : s.u;
    if (!moved.empty()) options_.on_stage(cost_.stages.back(), moved);
  }
  return s;
}

Solution SearchHost::assess(const netloft_stage& stage) { return solve(stage, {&no_solver(), {}}); }

void SearchHost::record(StageRecord stage, const VariantProblem& variant_problem) {
  stage.work += variant_problem.model.of(stage.statistics);
  cost_.statistics.add(stage.statistics);
  cost_.work += stage.work;
  cost_.stages.push_back(std::move(stage));
}

SearchHost::InnerCall::InnerCall(SearchHost& host, const std::string& strategy) : host_(host) {
  if (host.inner_calls_ >= kDeepestCall)
    throw std::invalid_argument(std::to_string(kDeepestCall) +
                                " strategies have called one another, the last " + strategy +
                                "; does one of them call itself?");
  ++host.inner_calls_;
}

Solution SearchHost::finish(Solution solution) const {
  solution.cost = cost_;
  return solution;
}

}  // namespace netloft
