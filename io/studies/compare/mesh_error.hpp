// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/compare/division.hpp"

namespace netloft::studies {

/// Estimates the mesh errors of the numbers in `result` by (4) and (5) of richardson.hpp. `own` is the scene
/// on its own mesh, `solution` its solution, and `result` the result of this solution. The scene is solved on
/// each mesh of `levels`, from the initial guess on this mesh. Adds a note to `result` that names these
/// meshes and numbers that do not converge, or gives the reason why there are no errors.
void find_mesh_errors(const runs::CaseSource& source, Registry& registry, runs::PreparedScene& own,
                      const Solution& solution, const std::vector<MeshLevel>& levels,
                      const runs::Watch& watch, results::Result& result);

}  // namespace netloft::studies
