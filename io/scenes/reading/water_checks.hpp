// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Warns of a current profile that does not reach the gear, and of a current that repeats the velocity of the
/// tow. `root` is the table of the scene.
void check_current(const Scene& scene, formats::TableReader& root);

}  // namespace netloft::scenes
