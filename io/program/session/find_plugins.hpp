// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/program/session/options.hpp"

namespace netloft::program {

/// Adds folders of plugins in the order of search: --plugins, NETLOFT_PLUGINS, the installed folder.
void find_plugins(const PluginOptions& options, Registry& registry);
/// Adds the folders of find_plugins(); with --scene-plugins, the folder of the scene comes after those of
/// --plugins.
void find_scene_plugins(const SceneOptions& options, Registry& registry);

}  // namespace netloft::program
