// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

namespace netloft::runs {

/// Finds the equilibrium in which the motion of the scene's integrator settles, starting from displacements
/// `from` (empty: the initial positions of the scene).
Solution settle(PreparedScene& scene, const Watch& watch, const std::vector<double>& from);

}  // namespace netloft::runs
