// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"
#include "io/scenes/reading/water_reader.hpp"

namespace netloft::scenes {

/// Reports an error if the scene has half a gear and differs between port and starboard.
void check_symmetry(formats::TableReader& root, const Draft& draft, const WaterReader& water);

/// Warns of implausible numbers in a scene that was read without errors: in its water, its tow and its parts.
/// The scene need not be divided into elements.
void check_undivided(formats::TableReader& root, const Draft& draft);

/// Checks whether a scene that was read without errors can be solved: its holds, its current, its ground and
/// bed, and parts that begin beyond the plane of symmetry.
void check_scene(formats::TableReader& root, const Draft& draft,
                 const std::vector<const ElementType*>& companions, const WaterReader& water);

}  // namespace netloft::scenes
