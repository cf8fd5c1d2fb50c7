// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Reports an error if a part states the opening angle of unloaded meshes but no stiffness against opening.
/// Without this stiffness, the angle has no effect.
void check_idle_keys(const Part& part, formats::TableReader& table);

/// Warns of T90 netting (turned by 90 degrees) without bending stiffness of twines and without opening
/// stiffness. It behaves exactly like diamond netting, because its twines have the same directions.
void check_turned_netting(const Part& part, const formats::Place& place, formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes
