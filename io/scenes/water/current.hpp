// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

namespace netloft::scenes {

/// Reads `water.current`: one velocity [vx, vy, vz]; a profile { z = […], x = […], y = […] } over height,
/// optionally with a factor over time; or velocities over time { t = […], x = […], y = […] }. If the key is
/// missing, the water is still.
Current read_current(formats::TableReader& water);

/// The velocities of a current at one time, from its lowest height to its highest [m/s].
using VelocitiesOverHeight = std::vector<std::array<double, 3>>;

/// The velocities of a current at all its given times and heights. The current is linear between them and
/// constant beyond them, so that its speed never exceeds the greatest of these velocities.
std::vector<VelocitiesOverHeight> velocities_at_kinks(const Current& current);

}  // namespace netloft::scenes
