// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace netloft::results {

/// The outline of a rigid body, such as an otter board, where it is at a state.
struct BodyPlate {
  std::uint32_t dot = 0;                           // its own element, of StoredMesh::dots
  std::vector<std::array<double, 3>> triangles{};  // three corners each, in the world [m]
};

/// The outlines of all bodies that have one and an element of their own.
std::vector<BodyPlate> plates_of(const StoredShape& stored, std::size_t state);

}  // namespace netloft::results
