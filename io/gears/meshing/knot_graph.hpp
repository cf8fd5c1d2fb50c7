// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/gear_mesh.hpp"
#include "io/gears/plan/recent.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace netloft::gears {

/// For each node, its neighbours along ropes and the lengths of rope to them [m].
using Neighbours = std::vector<std::vector<std::pair<std::uint32_t, double>>>;
Neighbours rope_neighbours(const GearMesh& mesh);

/// The desired difference of a field between two nodes, and its weight.
struct Gain {
  std::uint32_t from, to;
  double gain, weight;
};

/// The least-squares fit of a field to the desired differences `gains`, with given values at the nodes of
/// `fixed`. A small weight towards zero determines the field on parts of the mesh without a given value.
std::vector<double> by_gains(std::size_t nodes, const std::vector<Gain>& gains,
                             const std::vector<std::pair<std::uint32_t, double>>& fixed);

class GainFactors;

/// Fields that have given values at some nodes of a mesh and are as smooth as possible between them. The
/// matrix depends on the set of nodes with values; its factors are stored for the last few sets.
class HarmonicFields {
 public:
  explicit HarmonicFields(const GearMesh& mesh);
  std::vector<double> with(const std::vector<std::pair<std::uint32_t, double>>& fixed);

 private:
  std::size_t nodes_;
  std::vector<Gain> sides_;
  Recent<std::vector<std::uint32_t>, GainFactors> factors_{8};  // factors by the set of nodes with values
};

}  // namespace netloft::gears
