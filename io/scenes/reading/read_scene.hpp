// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// Reads a scene with all it includes, `overrides` ("path=value") laid on top. Everything wrong is put into
/// the diagnostics, located; use what is returned only if there are no errors. Opens the plugins the scene
/// names; `refused` is set when one of them is missing or must not run.
LoadedScene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       Registry& registry, formats::Diagnostics& diagnostics, bool& refused);

}  // namespace netloft::scenes
