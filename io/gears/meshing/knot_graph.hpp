// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

#include <utility>
#include <vector>

namespace netloft::gears {

/// A side of a triangle or a bar of a rope, between nodes of the gear.
struct MeshSide {
  std::uint32_t from, to;
};

/// All sides; one that several triangles have in common is listed once for each.
std::vector<MeshSide> sides_of(const GearMesh& mesh);

/// For each node, its neighbours along ropes and their distances [m].
using Neighbours = std::vector<std::vector<std::pair<std::uint32_t, double>>>;
Neighbours rope_neighbours(const GearMesh& mesh);

/// The wanted difference of a field between two nodes.
struct Gain {
  std::uint32_t from, to;
  double gain, weight;
};

/// The field whose differences are the gains in the sense of least squares. A small weight pulls it to zero,
/// so that it is determined on pieces without a tie. `fixed`: values at nodes that are kept.
std::vector<double> by_gains(std::size_t nodes, const std::vector<Gain>& gains,
                             const std::vector<std::pair<std::uint32_t, double>>& fixed);

/// The field with given values at some nodes that is as smooth as possible between them.
std::vector<double> harmonic(std::size_t nodes, const std::vector<MeshSide>& sides,
                             const std::vector<std::pair<std::uint32_t, double>>& fixed);

}  // namespace netloft::gears
