// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// The table of a solver, an integrator or a strategy in `[analysis]`: `newton` and `newton/newton` in
/// `newton`, `tension/stages` in `tension.stages`.
struct ComponentTable {
  std::string plugin, component;  // the latter empty where the plugin's name is enough
};
ComponentTable table_of_component(const std::string& name);

/// `[analysis]`: what is looked for, and by which solver with which parameters. Tables of others are read,
/// too, for a strategy may call them. `refused` is set when a plugin is missing or must not run.
Analysis read_analysis(formats::TableReader analysis, Registry& registry, bool& refused);

}  // namespace netloft::scenes
