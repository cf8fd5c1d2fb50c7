// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/make_result.hpp"
#include "io/results/figures/rope_tensions.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/compare/division.hpp"
#include "io/studies/compare/richardson.hpp"

#include <optional>

namespace netloft::studies {

/// The numbers that a run reports on one mesh.
struct NumbersOnMesh {
  MeshSize mesh;
  std::size_t unknowns = 0;
  double seconds = 0;  // wall time of the solver
  bool is_stable = true;
  std::vector<results::NamedScalar> scalars, gear;
  std::vector<results::RopeTensions> ropes;
};

/// The mesh and the numbers of a solved scene.
NumbersOnMesh numbers_of(runs::PreparedScene& solved, const Solution& solution,
                         const results::Result& result);

/// A pointer to the member `scalars` or `gear` of NumbersOnMesh.
using NumberGroup = std::vector<results::NamedScalar> NumbersOnMesh::*;

/// Solves a scene on another mesh. If forces do not balance at the end, returns nullopt, and sets `why_not`
/// to the reason. Accepts an unstable equilibrium, because its figures depend on the mesh in the same way as
/// those of a stable equilibrium.
std::optional<NumbersOnMesh> solve_on(const MeshLevel& level, const runs::CaseSource& source,
                                      Registry& registry, const runs::Watch& watch, std::string& why_not);

/// The limit of a number under mesh refinement, and the distance from this limit to the number on the mesh
/// with index `asked`. NaN if a mesh lacks the number.
Trend find_trend_of(const std::string& name, NumberGroup numbers, const std::vector<NumbersOnMesh>& meshes,
                    std::size_t asked);

}  // namespace netloft::studies
