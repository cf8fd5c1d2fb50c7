// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Refuses an opening angle of unloaded meshes that have no stiffness against opening.
void check_idle_keys(const Part& part, formats::TableReader& table);

/// Warns of T90 netting without bending stiffness and opening stiffness: its twines have the same directions
/// as in diamond netting and carry the same forces, so that turning the netting has no effect.
void check_turned_netting(const Part& part, const formats::Place& place, formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes
