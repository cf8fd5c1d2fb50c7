// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/case.hpp"

#include "io/scene/read_scene.hpp"
#include "solvers/factorisation/factorisation.hpp"

#include <stdexcept>

namespace netloft::io {

Case::Case(CaseSource source, Registry& registry) : source_(std::move(source)), registry_(registry) {}

Case::State Case::open(const std::function<void(LoadedScene&)>& change) {
  if (const State state = read(); state != State::ready) return state;
  if (change) change(loaded_);
  return assemble();
}

Case::State Case::read() {
  Timed timed(reading_seconds_);
  bool refused = false;
  loaded_ = read_scene(source_.file, source_.overrides, registry_, diagnostics_, refused);
  if (!diagnostics_.errors()) return State::ready;
  return refused ? State::refused : State::wrong_input;
}

Case::State Case::assemble() {
  Timed timed(setup_seconds_);
  try {
    plan_ = make_plan(loaded_.scene, registry_, loaded_.analysis.tangent);
    std::erase(plan_.not_loaded, registry_.solver(loaded_.analysis.solver).origin->name);
    assembler_ = std::make_unique<Assembler>(loaded_.scene, plan_, source_.threads);
  } catch (const SceneError& error) {
    for (const auto& fault : error.faults) diagnostics_.error(loaded_.place_of(fault.part), fault.message);
    return State::wrong_input;
  }
  return State::ready;
}

Solution Case::solve(const Watch& watch) {
  const SolverType& solver = registry_.solver(loaded_.analysis.solver);
  std::vector<std::string> faults;
  const ParameterBlock parameters(solver.parameters, solver.solver.parameter_bytes,
                                  loaded_.analysis.solver_parameters, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  Limits limits = loaded_.analysis.limits;
  limits.interrupt = watch.interrupt;
  return solve_static(loaded_.scene, *assembler_, solver, parameters.data(), limits, make_factorisation,
                      watch.on_iteration);
}

}  // namespace netloft::io
