// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// Warns of densities that no material has, of diameters that no rope has, and of floats that cannot exist.
/// Reports a rope that is stiffer in compression than in tension as an error. The limits and their reasons
/// are in plausible_parts.cpp.
void check_plausible_parts(const LoadedScene& loaded, formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes
