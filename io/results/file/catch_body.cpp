// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/catch_body.hpp"

#include "framework/registry/element_outputs.hpp"

#include <algorithm>
#include <map>

namespace netloft::results {

namespace {

using Side = std::array<std::uint32_t, 2>;

/// The numbers of triangles at an edge of the mesh with catch, and without catch.
struct Neighbours {
  int with = 0, without = 0;
};

std::map<Side, Neighbours> neighbours_of(const StoredMesh& mesh, const std::vector<bool>& is_filled) {
  std::map<Side, Neighbours> sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      Neighbours& side = sides[{a, b}];
      ++(is_filled[t] ? side.with : side.without);
    }
  return sides;
}

}  // namespace

CatchBody catch_body_of(const StoredShape& stored, std::size_t state) {
  CatchBody body;
  const auto is_pressure = [](const StoredField& field) { return field.name == output::kPressure.name; };
  if (std::none_of(stored.fields.begin(), stored.fields.end(), is_pressure)) return body;
  const auto pressure = stored.field(output::kPressure.name, state);
  const StoredMesh& mesh = stored.mesh;
  std::vector<bool> is_filled(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    is_filled[t] = pressure[mesh.triangle_cells[t]] > 0;
    if (is_filled[t]) body.triangles.push_back(static_cast<std::uint32_t>(t));
  }
  for (const auto& [side, beside] : neighbours_of(mesh, is_filled))
    if (beside.with > 0 && beside.without > 0) body.rim.push_back(side);
  return body;
}

}  // namespace netloft::results
