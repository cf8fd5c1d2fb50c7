// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/tiling.hpp"

#include <span>
#include <vector>

namespace netloft {

/// Whether both families have the same nodes, element by element, as riders have the nodes of the family that
/// they ride on. Maps and tilings of one family are then valid for the other.
bool have_same_nodes(const ElementFamily& a, const ElementFamily& b);

/// A family and its riders, which share one tiling. A tile is gathered once for all of them and scattered
/// after all of them have added to it.
struct FamilyGroup {
  Tiling tiling;
  std::vector<std::size_t> families;              // the family that the others ride on comes first
  std::uint32_t traits = 0;                       // union over all active terms
  std::size_t first_tile = 0;                     // index of the first tile among those of all groups
  std::vector<std::uint32_t> carried_tiles = {};  // tiles with nodes that a body carries
};

/// Groups families with the same nodes, in the order of the first family of each group. Tilings are not made
/// yet.
std::vector<FamilyGroup> find_family_groups(std::span<const std::unique_ptr<ElementFamily>> families);

}  // namespace netloft
