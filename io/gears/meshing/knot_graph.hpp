// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"

#include "io/gears/meshing/recent.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace netloft::gears {

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

class GainFactors;

/// Fields with given values at some nodes of a mesh that are as smooth as possible between them. The matrix
/// depends on which nodes have values; the factors of the last few such sets are kept.
class HarmonicFields {
 public:
  explicit HarmonicFields(const GearMesh& mesh);
  std::vector<double> with(const std::vector<std::pair<std::uint32_t, double>>& fixed);

 private:
  std::size_t nodes_;
  std::vector<Gain> sides_;
  Recent<std::vector<std::uint32_t>, GainFactors> factors_{8};  // by nodes with values
};

}  // namespace netloft::gears
