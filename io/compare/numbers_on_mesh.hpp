// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/analysis/case.hpp"
#include "io/compare/division.hpp"
#include "io/compare/richardson.hpp"
#include "io/report/run_result.hpp"

#include <optional>

namespace netloft::io {

/// What a run reports, on one mesh.
struct NumbersOnMesh {
  MeshCount mesh;
  std::size_t unknowns = 0;
  double seconds = 0;  // of the solver, wall time
  std::vector<NamedScalar> scalars, gear;
};

/// Which of the numbers.
using Numbers = std::vector<NamedScalar> NumbersOnMesh::*;

/// Solves a scene on another mesh. Nothing, and why in `why_not`, unless it converged.
std::optional<NumbersOnMesh> solve_on(const MeshLevel& level, const CaseSource& source, Registry& registry,
                                      const Watch& watch, std::string& why_not);

/// What a number tends to on finer and finer meshes, and how far it is from that on mesh `asked`. Unknown if
/// some mesh has no such number.
Trend find_trend_of(const std::string& name, Numbers numbers, const std::vector<NumbersOnMesh>& meshes,
                    std::size_t asked);

}  // namespace netloft::io
