// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Reads `water.current`: one velocity [vx, vy, vz]; a profile { z = […], x = […], y = […] } over height,
/// with a factor over time if it has one; or velocities over time { t = […], x = […], y = […] }. Without the
/// key the water is still.
Current read_current(formats::TableReader& water);

}  // namespace netloft::scenes
