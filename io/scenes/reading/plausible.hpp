// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::scenes {

/// Warns of numbers that are valid but probably a mistake, such as a density in another unit. `root` is the
/// table of the scene. The limits and their reasons are in plausible.cpp for the surroundings of a gear, in
/// plausible_parts.cpp for its parts.
void check_plausible(const LoadedScene& loaded, formats::TableReader& root);

/// Warns of a hold that moves faster than any ship or winch; `key` is the key of its course.
void check_speed_of_hold(const Course& course, formats::TableReader& hold, const char* key);

}  // namespace netloft::scenes
