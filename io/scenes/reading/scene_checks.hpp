// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"
#include "io/scenes/reading/water_reader.hpp"

namespace netloft::scenes {

/// Refuses half a gear if something distinguishes port from starboard.
void check_symmetry(formats::TableReader& root, const Draft& draft, const WaterReader& water);

/// Checks whether a scene without errors so far can be solved: its holds, its current, its ground and bed,
/// and parts that start on the wrong side of the plane of symmetry.
void check_scene(formats::TableReader& root, const Draft& draft,
                 const std::vector<const ElementType*>& companions, const WaterReader& water);

}  // namespace netloft::scenes
