// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Reports an error if the opening angle of unloaded meshes is given but the meshes have no stiffness against
/// opening, without which the angle has no effect.
void check_idle_keys(const Part& part, formats::TableReader& table);

/// Warns of T90 netting (turned by 90 degrees) that has neither bending stiffness of twines nor opening
/// stiffness: such netting behaves exactly like diamond netting, because its twines have the same directions.
void check_turned_netting(const Part& part, const formats::Place& place, formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes
