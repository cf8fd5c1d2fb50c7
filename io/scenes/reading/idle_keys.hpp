// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Refuses an angle of unloaded meshes where nothing draws the meshes to it.
void check_idle_keys(const Part& part, formats::TableReader& table);

/// Warns of netting turned by a right angle whose meshes resist nothing: without knots and bending, twines
/// that run the same ways carry the same, so that it is as if it were not turned.
void check_turned_netting(const Part& part, const formats::Place& place, formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes
