// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace netloft::results {

/// The place of the catch: the triangles of netting that it presses on, and the rim of its front.
struct CatchBody {
  std::vector<std::uint32_t> triangles;           // of StoredMesh::triangles
  std::vector<std::array<std::uint32_t, 2>> rim;  // sides of these that border on netting without catch
};

/// The catch at a state; empty if the result has none.
CatchBody catch_body_of(const StoredShape& stored, std::size_t state);

}  // namespace netloft::results
