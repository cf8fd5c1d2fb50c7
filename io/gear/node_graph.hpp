// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gear/gear_mesh.hpp"

#include <utility>
#include <vector>

namespace netloft::io {

/// A side of a triangle or a bar of a rope, between nodes of the gear.
struct MeshSide {
  std::uint32_t from, to;
};

/// All of them, those that triangles share once for each.
std::vector<MeshSide> sides_of(const GearMesh& mesh);

/// By node: the next ones along ropes and how far away they are [m].
using Neighbours = std::vector<std::vector<std::pair<std::uint32_t, double>>>;
Neighbours rope_neighbours(const GearMesh& mesh);

/// What a field should gain from a node to another.
struct Gain {
  std::uint32_t from, to;
  double gain, weight;
};

/// The field that gains as said in the sense of least squares; from nothing else it stays near zero, so that
/// it is determined on pieces without a tie. `fixed`: values at nodes, kept as they are.
std::vector<double> by_gains(std::size_t nodes, const std::vector<Gain>& gains,
                             const std::vector<std::pair<std::uint32_t, double>>& fixed);

/// The field with values at some nodes that is as smooth as can be between them.
std::vector<double> harmonic(std::size_t nodes, const std::vector<MeshSide>& sides,
                             const std::vector<std::pair<std::uint32_t, double>>& fixed);

}  // namespace netloft::io
