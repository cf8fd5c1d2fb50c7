// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/bottom.hpp"

namespace netloft::scenes {

/// `[tow]`: lets water and ground pass the gear. Without the table both are as they are written elsewhere.
void read_tow(formats::TableReader tow, Scene& scene);

/// `[bed]`: the bed of the sea, and what it is made of.
SeaBottom read_bed(formats::TableReader bed, Scene& scene);

/// The friction of a part where the ground does not pass: one that remembers where it held (reads_state)
/// sticks, and any other is none.
enum class StandingFriction { not_asked, none, sticks };
StandingFriction friction_on_standing_ground(const Scene& scene, const Part& part, const ElementType& type);

}  // namespace netloft::scenes
