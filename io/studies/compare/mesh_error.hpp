// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/case.hpp"
#include "io/studies/compare/division.hpp"
#include "io/results/figures/run_result.hpp"

namespace netloft::io {

/// Solves the scene of `own` on other meshes and fills in the mesh errors of the scalars of `result` (the
/// answer of `own`), richardson.hpp (4). Adds a note that says which meshes were used, what does not converge
/// with them, or why there are no errors. Each level is solved as the scene says, from its own initial guess.
void find_mesh_errors(const CaseSource& source, Registry& registry, const Case& own,
                      const std::vector<MeshLevel>& levels, const Watch& watch, RunResult& result);

}  // namespace netloft::io
