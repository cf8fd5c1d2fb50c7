// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/compare/division.hpp"

namespace netloft::studies {

/// Solves the scene of `own` on other meshes and sets the mesh errors of the scalars of `result` (the answer
/// of `own`), richardson.hpp (4), (5). Adds a note on the meshes used, on numbers that do not converge, or on
/// the reason why there are no errors. Each level is solved by the analysis of the scene, from its own
/// initial guess.
void find_mesh_errors(const runs::CaseSource& source, Registry& registry, runs::PreparedScene& own,
                      const Solution& solution, const std::vector<MeshLevel>& levels,
                      const runs::Watch& watch, results::Result& result);

}  // namespace netloft::studies
