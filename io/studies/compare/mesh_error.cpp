// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/mesh_error.hpp"

#include "io/studies/compare/rope_ends.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace netloft::studies {

namespace {

/// Sets the mesh errors of the numbers `judged`, which are those on mesh `own`. Adds a sentence to the note
/// for every tension at a rope end that has no limit under mesh refinement.
void judge(const std::vector<NumbersOnMesh>& meshes, std::size_t own, NumberGroup numbers,
           std::vector<results::NamedScalar>& judged, std::string& note) {
  for (auto& scalar : judged) {
    const Trend trend = find_trend_of(scalar.name, numbers, meshes, own);
    if (trend.diverges && is_of_rope_end(scalar.name)) {
      note += ";\n" + divergence_text(scalar.name, meshes, own);
      continue;
    }
    scalar.mesh_error = trend.error;
    if (trend.steady) scalar.mesh_order = trend.order;
  }
}

/// The meshes that were used ("300, 600 (not stable)"), and how errors were estimated from them.
std::string note_on(const std::vector<NumbersOnMesh>& meshes) {
  std::vector<std::string> counts;
  for (const auto& mesh : meshes)
    counts.push_back(std::to_string(mesh.mesh.count) + (mesh.is_stable ? "" : " (not stable)"));
  return fmt::format(
      "is estimated from {} {}: 1.25 times {}", fmt::join(counts, ", "), meshes.front().mesh.of,
      meshes.front().mesh.is_similar ? "the distance to the value extrapolated with the observed order, or "
                                       "the largest difference between meshes"
                                     : "the largest difference between meshes, or to an extrapolated value");
}

/// Sorts the meshes from the coarsest to the finest. The first of them is the scene's own mesh; its new index
/// is returned.
std::size_t sort_meshes(std::vector<NumbersOnMesh>& meshes) {
  const std::int64_t own = meshes.front().mesh.count;
  std::sort(meshes.begin(), meshes.end(),
            [](const auto& a, const auto& b) { return a.mesh.width > b.mesh.width; });
  const auto at =
      std::find_if(meshes.begin(), meshes.end(), [&](const auto& m) { return m.mesh.count == own; });
  return static_cast<std::size_t>(at - meshes.begin());
}

}  // namespace

void find_mesh_errors(const runs::CaseSource& source, Registry& registry, runs::PreparedScene& own,
                      const Solution& solution, const std::vector<MeshLevel>& levels,
                      const runs::Watch& watch, results::Result& result) {
  if (!is_stationary(solution)) {
    result.mesh_note = "is not known: the scene itself did not converge";
    return;
  }
  std::vector<NumbersOnMesh> meshes{numbers_of(own, solution, result)};
  std::string missing;
  for (const auto& level : levels) {
    std::string why_not;
    if (auto solved = solve_on(level, source, registry, watch, why_not))
      meshes.push_back(std::move(*solved));
    else
      missing += ";\n" + why_not;
  }
  if (meshes.size() < 2) {
    result.mesh_note = "is not known: " + missing.substr(2);
    return;
  }
  const std::size_t at = sort_meshes(meshes);
  result.mesh_note = note_on(meshes) + missing;
  judge(meshes, at, &NumbersOnMesh::scalars, result.scalars, result.mesh_note);
  judge(meshes, at, &NumbersOnMesh::gear, result.figures, result.mesh_note);
}

}  // namespace netloft::studies
