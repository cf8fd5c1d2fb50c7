// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/compare/division.hpp"

namespace netloft::studies {

/// Solves the scene on other meshes, and sets the mesh errors of the numbers in `result`, the answer on the
/// scene's own mesh, by (4) and (5) of richardson.hpp. Adds a note on the meshes used and on numbers that do
/// not converge, or the reason why there are no errors. Every mesh is solved as the scene says, from its own
/// initial guess. `own` and `solution` are the scene and its answer on its own mesh.
void find_mesh_errors(const runs::CaseSource& source, Registry& registry, runs::PreparedScene& own,
                      const Solution& solution, const std::vector<MeshLevel>& levels,
                      const runs::Watch& watch, results::Result& result);

}  // namespace netloft::studies
