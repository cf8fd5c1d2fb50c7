// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

#include <limits>

namespace netloft::runs {

/// Integrates the motion of the scene in time, as its table [analysis] says, from the state `from`, or from
/// the start of the scene if `from` is nullptr. `work` limits the total work of all steps, in the unit of
/// work_of_steps().
MarchResult march(PreparedScene& scene, const MarchWatch& outputs, const Watch& watch = {},
                  const MarchState* from = nullptr, double work = std::numeric_limits<double>::infinity());

/// Makes the elements store displacements `u` as the last accepted step.
void remember(PreparedScene& scene, std::span<const double> u);

}  // namespace netloft::runs
