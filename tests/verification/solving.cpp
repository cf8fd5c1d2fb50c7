// SPDX-License-Identifier: BSD-3-Clause
#include "tests/verification/solving.hpp"
#include "framework/assembler/reports.hpp"
#include "tests/folders.hpp"

#include "framework/search/search.hpp"
#include "solvers/factorisation/kept_analyses.hpp"

#include <algorithm>
#include <stdexcept>

#ifdef NETLOFT_STATIC
#include "netloft_static_plugins.hpp"
#endif

namespace netloft::test {

Registry& shipped_plugins() {
  static Registry registry;
  [[maybe_unused]] static const bool filled = [] {
#ifdef NETLOFT_STATIC
    for (const auto& [name, describe] : program::static_plugins()) registry.add_builtin(name, describe);
#endif
    registry.add_folder(test::plugin_folder());
    return true;
  }();
  return registry;
}

namespace {

ParameterBlock parameters_of(const SolverType& solver, const Values& values) {
  std::vector<std::string> faults;
  ParameterBlock parameters(solver.parameters, solver.solver.parameter_bytes, values, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  return parameters;
}

Solution find_by_strategy(const Solved& s, const Solving& how) {
  Registry& registry = shipped_plugins();
  SearchOptions options;
  options.solver = {&registry.solver(how.solver), how.solver_parameters};
  options.limits = how.limits, options.work = how.work, options.given = how.given;
  return find_equilibrium({&s.scene, s.assembler.get(), &registry, nullptr, keep_analyses(how.make),
                           TangentChoice::exact, how.threads},
                          options, {&registry.strategy(how.strategy), how.strategy_parameters});
}

}  // namespace

Solved solve(Scene scene, const Solving& how) {
  const SolverType& solver = shipped_plugins().solver(how.solver);
  const ParameterBlock parameters = parameters_of(solver, how.solver_parameters);
  Solved s{std::move(scene), {}, nullptr, {}};
  s.plan = make_scene_plan(s.scene, shipped_plugins());
  s.assembler = std::make_unique<Assembler>(s.scene, s.plan, how.threads);
  if (how.strategy.empty())
    s.solution = solve_static({s.scene, *s.assembler, how.make}, {&solver, parameters.data()}, how.limits);
  else
    s.solution = find_by_strategy(s, how);
  return s;
}

netloft_outcome solve_problem(netloft_problem& problem, const std::string& solver, const Values& parameters) {
  const SolverType& type = shipped_plugins().solver(solver);
  return call_solver({&type, parameters_of(type, parameters).data()}, problem);
}

double elastic_energy(const Solved& solved) {
  Scene scene = solved.scene;
  scene.water.gravity = 0;
  const ScenePlan plan = make_scene_plan(scene, shipped_plugins());
  Assembler assembler(scene, plan, 1);
  double energy = 0;
  if (!assembler.evaluate(solved.solution.x, {.energy = &energy}))
    throw std::runtime_error(assembler.fault_sentence(scene));
  return energy;
}

std::array<double, 3> Solved::vector_at(const std::vector<double>& v, std::uint32_t node) const {
  std::array<double, 3> at{};
  for (int axis = 0; axis < 3; ++axis)
    at[static_cast<std::size_t>(axis)] = v[assembler->numbering().dof(node, axis).at()];
  return at;
}

std::array<double, 3> Solved::total_reaction() const {
  std::array<double, 3> sum{};
  for (std::uint32_t n = 0; n < scene.node_count(); ++n)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (scene.held[n] & (1 << axis)) sum[axis] += reaction(n)[axis];
  return sum;
}

double Solved::lowest_z() const {
  double lowest = position(0)[2];
  for (std::uint32_t n = 1; n < scene.node_count(); ++n) lowest = std::min(lowest, position(n)[2]);
  return lowest;
}

std::vector<double> Solved::output(const std::string& name) const {
  const auto& outputs = assembler->families()[0]->type().outputs;
  std::vector<std::vector<double>> values;
  assembler->reports().outputs(solution.x, 0, values);
  for (std::size_t k = 0; k < outputs.size(); ++k)
    if (outputs[k].name == name) return values[k];
  throw std::invalid_argument("no output \"" + name + "\"");
}

}  // namespace netloft::test
