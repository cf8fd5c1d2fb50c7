// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/bottom.hpp"

namespace netloft::scenes {

/// Reads `[tow]`, the velocity at which water and ground pass the gear.
void read_tow(formats::TableReader tow, Scene& scene);

/// Reads `[bed]`: sets the seabed of the scene, and returns its material.
SeaBottom read_bed(formats::TableReader bed, Scene& scene);

/// How the friction of a part behaves on ground at rest. `not_asked`: the ground moves, or the part has no
/// friction. `sticks`: the element remembers the place on the ground to which it sticks
/// (NETLOFT_READS_STATE). `none`: the element has friction only if the ground moves.
enum class StandingFriction { not_asked, none, sticks };
StandingFriction friction_on_standing_ground(const Scene& scene, const Part& part, const ElementType& type);

}  // namespace netloft::scenes
