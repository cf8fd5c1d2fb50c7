// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

namespace netloft::runs {

/// Finds an equilibrium by integrating a damped motion with the integrator of the scene until it comes to
/// rest. The motion starts at displacements `from` (empty: the initial positions of the scene).
Solution settle(PreparedScene& scene, const Watch& watch, const std::vector<double>& from);

}  // namespace netloft::runs
