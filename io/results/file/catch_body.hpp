// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace netloft::results {

/// The extent of the catch in a cod-end: the triangles of netting under the pressure of the catch, and the
/// border of the region that they form.
struct CatchBody {
  std::vector<std::uint32_t> triangles;  // indices into StoredMesh::triangles
  // Edges (pairs of nodes) between a triangle with catch and one without.
  std::vector<std::array<std::uint32_t, 2>> rim;
};

/// The catch in a state of a result; without triangles if the gear has no catch.
CatchBody catch_body_of(const StoredShape& stored, std::size_t state);

}  // namespace netloft::results
