// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/analysis/case.hpp"
#include "io/compare/division.hpp"
#include "io/report/run_result.hpp"

namespace netloft::io {

/// Solves the scene of `own` on other meshes and fills in the mesh errors of the scalars of `result`, which
/// is the answer of `own`, by Richardson's extrapolation; and a note about what they were found from, or why
/// there are none. Each level is solved as the scene says, from its own start.
void find_mesh_errors(const CaseSource& source, Registry& registry, const Case& own,
                      const std::vector<MeshLevel>& levels, const Watch& watch, RunResult& result);

}  // namespace netloft::io
