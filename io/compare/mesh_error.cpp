// SPDX-License-Identifier: BSD-3-Clause
#include "io/compare/mesh_error.hpp"

#include "io/compare/numbers_on_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace netloft::io {

namespace {

void judge(const std::vector<NumbersOnMesh>& meshes, std::size_t own, Numbers numbers,
           std::vector<NamedScalar>& judged) {
  for (auto& scalar : judged) {
    const Trend trend = find_trend_of(scalar.name, numbers, meshes, own);
    scalar.mesh_error = trend.error;
    if (trend.steady) scalar.mesh_order = trend.order;
  }
}

std::string note_on(const std::vector<NumbersOnMesh>& meshes) {
  std::vector<std::int64_t> counts;
  for (const auto& mesh : meshes) counts.push_back(mesh.mesh.count);
  return fmt::format("from {} {}, {}", fmt::join(counts, ", "), meshes.front().mesh.of,
                     meshes.size() > 2 ? "extrapolated where an order is given, else the largest difference"
                                       : "first order assumed");
}

/// Sorts from the coarsest mesh to the finest; returns the new index of the mesh that was first.
std::size_t sort_meshes(std::vector<NumbersOnMesh>& meshes) {
  const std::int64_t own = meshes.front().mesh.count;
  std::sort(meshes.begin(), meshes.end(),
            [](const auto& a, const auto& b) { return a.mesh.width > b.mesh.width; });
  const auto at =
      std::find_if(meshes.begin(), meshes.end(), [&](const auto& m) { return m.mesh.count == own; });
  return static_cast<std::size_t>(at - meshes.begin());
}

}  // namespace

void find_mesh_errors(const CaseSource& source, Registry& registry, const Case& own,
                      const std::vector<MeshLevel>& levels, const Watch& watch, RunResult& result) {
  if (result.solution.status != SolveStatus::converged) {
    result.mesh_note = "is not known: the scene itself did not converge";
    return;
  }
  std::vector<NumbersOnMesh> meshes{{count_mesh(own.loaded()), 0, 0, result.scalars, result.gear}};
  for (const auto& level : levels) {
    std::string why_not;
    auto solved = solve_on(level, source, registry, watch, why_not);
    if (!solved) {
      result.mesh_note = "is not known: " + why_not;
      return;
    }
    meshes.push_back(std::move(*solved));
  }
  const std::size_t at = sort_meshes(meshes);
  judge(meshes, at, &NumbersOnMesh::scalars, result.scalars);
  judge(meshes, at, &NumbersOnMesh::gear, result.gear);
  result.mesh_note = note_on(meshes);
}

}  // namespace netloft::io
