// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/program/session/options.hpp"

namespace netloft::program {

/// Adds folders in the order of search: --plugins, NETLOFT_PLUGINS, the installed one.
void find_plugins(const PluginOptions& options, Registry& registry);
/// The same, with the folder of the scene after --plugins if --scene-plugins is given.
void find_scene_plugins(const SceneOptions& options, Registry& registry);

}  // namespace netloft::program
