// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/scene/loaded_scene.hpp"
#include "io/toml/table_reader.hpp"

namespace netloft::io {

/// `[analysis]`: what is looked for, and by which solver with which parameters; tables of other solvers may
/// stay in the file. `refused` is set when a plugin is missing or must not run.
Analysis read_analysis(TableReader analysis, Registry& registry, bool& refused);

}  // namespace netloft::io
