// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scene/loaded_scene.hpp"
#include "io/toml/diagnostics.hpp"

namespace netloft::io {

/// Refuses a bed that lies above the whole gear, and two beds under one node; warns of what is held below
/// its bed, and of beds at different depths under one gear.
void check_beds(const LoadedScene& loaded, Diagnostics& diagnostics);

}  // namespace netloft::io
