// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace netloft::results {

/// The shape of a rigid body, such as an otter board, in one state, for pictures.
struct BodyPlate {
  std::uint32_t dot = 0;  // the element at the origin of the body, as an index in StoredMesh::dots
  std::vector<std::array<double, 3>> triangles{};  // three corners for each triangle, in world coordinates
                                                   // [m]
};

/// The shapes of all bodies that have an outline and an element at their origin.
std::vector<BodyPlate> plates_of(const StoredShape& stored, std::size_t state);

}  // namespace netloft::results
