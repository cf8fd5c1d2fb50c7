// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// The table within `[analysis]` that has the parameters of a solver, an integrator or a strategy:
/// for example, [analysis.newton] for `newton` or `newton/newton`, and [analysis.tension.stages] for
/// `tension/stages`.
struct ComponentTable {
  std::string plugin, component;  // component: empty if the table has only the plugin's name
};
ComponentTable table_of_component(const std::string& name);

/// Whether the name given for a solver is that of an integrator, whose damped motion then finds the
/// equilibrium. Opens the plugin.
bool is_integrator(Registry& registry, const std::string& name);

/// Reads `[analysis]`: the kind of analysis, the solver and the strategy with their parameters. Also reads
/// the tables of other solvers and strategies, because a strategy may call them. Sets `refused` if a plugin
/// is missing or was rejected.
Analysis read_analysis(formats::TableReader analysis, Registry& registry, bool& refused);

}  // namespace netloft::scenes
