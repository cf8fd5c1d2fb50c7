// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"
#include "io/scenes/reading/water_reader.hpp"

namespace netloft::scenes {

/// Half a gear stands for a whole one only if nothing tells port from starboard.
void check_symmetry(formats::TableReader& root, const Draft& draft, const WaterReader& water);

/// Whether a scene without errors so far can be solved as it stands: what is held, what passes the gear, what
/// it rests on, and what begins on the wrong side of the plane of symmetry.
void check_scene(formats::TableReader& root, const Draft& draft,
                 const std::vector<const ElementType*>& companions, const WaterReader& water);

}  // namespace netloft::scenes
