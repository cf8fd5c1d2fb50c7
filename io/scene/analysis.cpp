// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/analysis.hpp"

#include "io/scene/element_choice.hpp"
#include "io/scene/keys.hpp"
#include "io/scene/parameter_reader.hpp"

namespace netloft::io {

namespace {

/// The table of a component: of newton and of newton/newton `analysis.newton`.
TableReader own_table(TableReader& analysis, const std::string& name) {
  return analysis.table(name.substr(0, name.find('/')), Presence::optional);
}

/// An integrator as a solver: `solver` is its name, and motion has to die.
void read_settling(TableReader& table, Registry& registry, Analysis& a) {
  a.dynamics.integrator = a.solver;
  const IntegratorType& type = registry.integrator(a.solver);
  TableReader own = own_table(table, a.solver);
  a.dynamics.integrator_parameters = read_parameters(type.parameters, own);
  if (!table.has("mass_damping")) a.dynamics.march.mass_damping = 1;
  if (!table.has("duration")) a.dynamics.march.duration = 1e6;
  if (!table.has("max_iterations")) a.limits.iterations = 1000000;
  a.dynamics.march.output_interval = 0, a.dynamics.march.budget = false;
}

/// What speaks of time. True: no solver of an equilibrium is wanted.
bool read_time(TableReader& table, Registry& registry, Analysis& a) {
  const bool moves = a.kind == AnalysisKind::dynamics;
  a.settles = !moves && is_integrator(registry, a.solver);
  if (!moves && !a.settles) {
    for (const auto& key : dynamics_keys()) table.has(key.name);  // may stay for another day
    return false;
  }
  a.dynamics = read_dynamics(table, registry);
  if (!table.has("tangent")) a.tangent = TangentChoice::symmetric;
  if (moves && !table.has("tolerance")) a.limits.tolerance = 1e-5;
  if (moves && !table.has("max_iterations")) a.limits.iterations = 25;
  a.continuation = a.continuation && !moves && !a.settles;
  if (a.settles) read_settling(table, registry, a);
  return a.settles;
}

void read_solver(TableReader& table, Registry& registry, Analysis& a) {
  const SolverType& solver = registry.solver(a.solver);
  TableReader own = own_table(table, a.solver);
  a.solver_parameters = read_parameters(solver.parameters, own);
  // A step begins so near its end that Newton's method wants no damping.
  if (a.kind == AnalysisKind::dynamics && a.solver == "newton")
    a.solver_parameters.try_emplace("damping", 0.0);
}

Analysis from_keys(const AnalysisKeys& keys) {
  Analysis a;
  a.solver = keys.solver;
  a.automatic = a.solver == "auto";
  if (a.automatic) a.solver = "newton";
  a.in_stages = keys.continuation == 3;
  a.continuation = keys.continuation == 1 || a.in_stages || (keys.continuation == 0 && a.automatic);
  a.tangent = static_cast<TangentChoice>(keys.tangent);
  a.limits = {keys.tolerance, static_cast<int>(keys.max_iterations), keys.max_seconds, nullptr};
  a.kind = static_cast<AnalysisKind>(keys.kind);
  a.looks = keys.looks < 0 && !a.automatic ? 0 : static_cast<int>(keys.looks);
  return a;
}

}  // namespace

Analysis read_analysis(TableReader table, Registry& registry, bool& refused) {
  const Values values = read_parameters(analysis_keys(), table);
  std::vector<std::string> faults;
  const ParameterBlock block(analysis_keys(), sizeof(AnalysisKeys), values, faults);
  for (const auto& name : registry.available()) table.has(name);
  if (!faults.empty()) return {};
  Analysis a = from_keys(*static_cast<const AnalysisKeys*>(block.data()));
  if (a.solver.empty()) {
    table.error("solver", "is empty; the name of a solver is wanted, such as newton");
    return a;
  }
  try {
    if (!read_time(table, registry, a)) read_solver(table, registry, a);
  } catch (const PluginRefused& e) {
    refused = true;
    report_refusal(table, "solver", e.what());
  }
  return a;
}

}  // namespace netloft::io
