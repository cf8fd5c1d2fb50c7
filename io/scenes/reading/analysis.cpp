// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/analysis.hpp"

#include "framework/registry/wrong_kind.hpp"
#include "framework/search/named_component.hpp"
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/keys.hpp"
#include "io/scenes/reading/parameter_reader.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace netloft::scenes {

namespace {

formats::TableReader own_table(formats::TableReader& analysis, const std::string& name) {
  const ComponentTable at = table_of_component(name);
  formats::TableReader plugin = analysis.table(at.plugin, formats::Presence::optional);
  return at.component.empty() ? plugin : plugin.table(at.component, formats::Presence::optional);
}

/// The parameters that the scene gives to a solver, an integrator or a strategy. The first call for a
/// component reads them; later calls for it return the same values.
template <class Type>
const Values& parameters_of(const Type& component, formats::TableReader& analysis, Analysis& a) {
  const auto [given, is_new] = a.given.try_emplace(component.type);
  if (is_new) {
    formats::TableReader own = own_table(analysis, component.type);
    given->second = read_parameters(component.parameters, own);
  }
  return given->second;
}

/// Reads the settings for a `solver` that is an integrator. A damped motion that comes to rest then finds the
/// equilibrium. Therefore mass damping is on by default.
void read_settling(formats::TableReader& table, Registry& registry, Analysis& a) {
  a.dynamics.integrator = a.solver;
  const IntegratorType& type = registry.integrator(a.solver);
  a.dynamics.integrator_parameters = parameters_of(type, table, a);
  if (!table.has("mass_damping")) a.dynamics.march.mass_damping = 1;
  if (!table.has("duration")) a.dynamics.march.duration = 1e6;
  if (!table.has("max_iterations")) a.limits.iterations = 1000000;
  a.dynamics.march.output_interval = 0;
  a.dynamics.march.budget = false;
}

/// Reports keys of motions as errors in a static analysis, because the user may have forgotten kind =
/// "dynamic". If the scene states its `kind`, these keys are allowed.
void pass_over_time(formats::TableReader& table) {
  bool is_refused = table.has("kind");  // the scene states kind = "static"
  for (const auto& key : dynamics_keys())
    if (table.has(key.name) && !std::exchange(is_refused, true))
      table.error(
          key.name, "has no effect on an equilibrium",
          "write kind = \"dynamic\" for a motion, or kind = \"static\" to keep this key without using it");
}

/// Reads the keys of motions. Returns true if the analysis needs no solver for equilibria, because a motion
/// finds the equilibrium.
bool read_time(formats::TableReader& table, Registry& registry, Analysis& a) {
  const bool moves = a.kind == AnalysisKind::dynamics;
  a.settles = !moves && is_integrator(registry, a.solver);
  if (!moves && !a.settles) {
    pass_over_time(table);
    return false;
  }
  a.dynamics = read_dynamics(table, registry);
  if (!a.dynamics.integrator.empty())
    a.dynamics.integrator_parameters = parameters_of(registry.integrator(a.dynamics.integrator), table, a);
  if (!table.has("tangent")) a.tangent = TangentChoice::symmetric;
  if (moves && !table.has("tolerance")) a.limits.tolerance = 1e-5;
  if (moves && !table.has("max_iterations")) a.limits.iterations = 25;
  if (a.settles) read_settling(table, registry, a);
  return a.settles;
}

void read_solver(formats::TableReader& table, Registry& registry, Analysis& a) {
  const SolverType& solver = registry.solver(a.solver);
  a.solver_parameters = parameters_of(solver, table, a);
  // The start of a time step is so close to its solution that Newton's method needs no damping.
  if (a.kind == AnalysisKind::dynamics && a.solver == "newton")
    a.solver_parameters.try_emplace("damping", 0.0);
}

/// Reads the strategy. If a static analysis names only a solver, the strategy is kStrategyOfNamedSolver, so
/// that the result shows what this solver can do alone. In a motion, `solver` solves the time steps, and the
/// strategy finds the equilibrium at which the motion may start.
void read_strategy(formats::TableReader& table, Registry& registry, const Values& values, Analysis& a) {
  const bool only_solver = values.contains("solver") && !values.contains("strategy");
  if (only_solver && a.kind == AnalysisKind::statics) a.strategy = kStrategyOfNamedSolver;
  const StrategyType& strategy = registry.strategy(a.strategy);
  a.strategy_parameters = parameters_of(strategy, table, a);
}

/// Clears the strategy, and warns if the scene names one: a damped motion that comes to rest at the
/// equilibrium needs no strategy.
void pass_over_strategy(formats::TableReader& table, Registry& registry, const Values& values, Analysis& a) {
  if (values.contains("strategy")) {
    registry.strategy(a.strategy);
    table.diagnostics().warning(
        table.place("strategy"),
        table.path("strategy") + " has no effect: the integrator " + a.solver +
            " finds the equilibrium by a motion in time, without a strategy",
        "leave strategy out, or choose a solver such as newton, which a strategy can use");
  }
  a.strategy.clear();
}

Analysis from_keys(const AnalysisKeys& keys) {
  Analysis a;
  a.strategy = keys.strategy;
  a.solver = keys.solver;
  a.work = keys.work;
  a.tangent = static_cast<TangentChoice>(keys.tangent);
  a.limits.tolerance = keys.tolerance;
  a.limits.iterations = static_cast<int>(keys.max_iterations);
  a.limits.seconds = keys.max_seconds;
  a.limits.judging.accept_oscillation = keys.swinging != 0;
  a.kind = static_cast<AnalysisKind>(keys.kind);
  return a;
}

/// Calls `read`. If `read` finds no usable plugin, reports an error at `key` and sets `refused`.
template <class Read>
void read_component(formats::TableReader& table, const char* key, bool& refused, const Read& read) {
  try {
    read();
  } catch (const PluginRefused& e) {
    refused |= blames_plugin(e);
    report_refusal(table, key, e.what());
  }
}

/// Reports keys of earlier versions, each with the key that replaces it.
void report_successors(formats::TableReader& table) {
  constexpr std::array<std::array<const char*, 2>, 2> kSuccessors = {
      {{"continuation", "strategy = \"auto\" solves easier variants first; \"direct\" does not"},
       {"look"
        "s",
        "analysis.auto.restarts, or --strategy auto:restarts=6"}}};
  for (const auto& [key, successor] : kSuccessors)
    if (table.has(key)) table.error(key, "is no longer a key of [analysis]", successor);
}

/// Whether a plugin has a component of the kind `Type` with this name. Opens the plugin.
template <class Type>
bool is_offered(Registry& registry, const std::string& name, std::vector<Type> PluginContent::*kind) {
  const ComponentTable at = table_of_component(name);
  const std::string type = at.plugin + "/" + (at.component.empty() ? at.plugin : at.component);
  try {
    const auto& all = registry.plugin(at.plugin).*kind;
    return std::ranges::find(all, type, &Type::type) != all.end();
  } catch (const PluginRefused&) {
    return false;
  }
}

/// Checks the names of solvers and strategies in the parameters of a strategy.
void check_named_by(const StrategyType& strategy, const GivenValues& given, formats::TableReader own,
                    Registry& registry, bool& refused) {
  const Values& values = given.at(strategy.type);
  for (const auto& parameter : strategy.parameters) {
    if (!names_component(parameter) || own.kind(parameter.name) != formats::Kind::text) continue;
    try {
      check_named(parameter, std::get<std::string>(values.at(parameter.name)), registry, given,
                  {strategy.type});
    } catch (const PluginRefused& e) {
      refused |= blames_plugin(e);
      report_refusal(own, parameter.name, e.what());
    } catch (const std::invalid_argument& e) {
      own.error(parameter.name, e.what());
    }
  }
}

/// Checks the names of solvers and strategies in the tables of all strategies, because any strategy may be
/// called by another one.
void check_names(formats::TableReader& table, Registry& registry, const Analysis& a, bool& refused) {
  for (const auto& [type, values] : a.given)
    for (const auto& strategy : registry.plugin(table_of_component(type).plugin).strategies)
      if (strategy.type == type) check_named_by(strategy, a.given, own_table(table, type), registry, refused);
}

/// Reads the tables of solvers, integrators and strategies that the scene does not choose itself, because a
/// strategy may call them.
void read_others(formats::TableReader& table, Registry& registry, Analysis& a) {
  const auto read = [&](const auto& all) {
    for (const auto& component : all) parameters_of(component, table, a);
  };
  for (const auto& name : registry.available()) {
    if (!table.has(name)) continue;
    const PluginContent& plugin = registry.plugin(name);
    read(plugin.solvers);
    read(plugin.integrators);
    read(plugin.strategies);
  }
}

}  // namespace

ComponentTable table_of_component(const std::string& name) {
  const auto slash = name.find('/');
  const std::string plugin = name.substr(0, slash);
  const std::string component = slash == std::string::npos ? plugin : name.substr(slash + 1);
  return {plugin, component == plugin ? "" : component};
}

bool is_integrator(Registry& registry, const std::string& name) {
  return is_offered(registry, name, &PluginContent::integrators);
}

Analysis read_analysis(formats::TableReader table, Registry& registry, bool& refused) {
  const Values values = read_parameters(analysis_keys(), table);
  report_successors(table);
  std::vector<std::string> faults;
  const ParameterBlock block(analysis_keys(), sizeof(AnalysisKeys), values, faults);
  if (!faults.empty()) return {};
  Analysis a = from_keys(*static_cast<const AnalysisKeys*>(block.data()));
  if (a.solver.empty()) {
    table.error("solver", "is empty; give the name of a solver, such as newton");
    return a;
  }
  if (a.strategy.empty()) {
    table.error("strategy", "is empty; give the name of a strategy, such as auto");
    return a;
  }
  if (is_offered(registry, a.solver, &PluginContent::strategies)) {
    table.error("solver", "\"" + a.solver + "\" is a strategy, not a solver",
                "write --strategy " + a.solver + ", or strategy = \"" + a.solver + "\" in [analysis]");
    return a;
  }
  bool settles = false;
  read_component(table, "integrator", refused, [&] { settles = read_time(table, registry, a); });
  if (!settles) read_component(table, "solver", refused, [&] { read_solver(table, registry, a); });
  if (!refused)
    read_component(table, "strategy", refused, [&] {
      settles ? pass_over_strategy(table, registry, values, a) : read_strategy(table, registry, values, a);
    });
  read_component(table, "strategy", refused, [&] { read_others(table, registry, a); });
  check_names(table, registry, a, refused);
  return a;
}

}  // namespace netloft::scenes
