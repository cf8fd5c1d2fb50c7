// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/tree.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Writes what the parts are, beside their names what a picture needs of them: diameters, directions of
/// twines, places on the plan, the seabed.
void write_parts(formats::Tree& tree, const scenes::LoadedScene& loaded);

/// Writes the bill of materials of a scene with a net plan below /netloft/bill, rigid bodies last.
void write_bill(formats::Tree& tree, const scenes::LoadedScene& loaded);

}  // namespace netloft::results
