// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/tree.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Writes the parts: their names and, for pictures, diameters, directions of twines, places on the plan,
/// rigid bodies and the seabed.
void write_parts(formats::Tree& tree, const scenes::LoadedScene& loaded);

}  // namespace netloft::results
