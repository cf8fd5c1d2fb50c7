// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/tiling.hpp"

#include <span>
#include <vector>

namespace netloft {

/// Whether two families have the same nodes, element by element. A rider is a family that adds forces at the
/// nodes of another family, such as bending at the bars of a rope. A family and its riders therefore use the
/// same maps and tilings.
bool have_same_nodes(const ElementFamily& a, const ElementFamily& b);

/// A family and its riders, which share the same tiles. The inputs of a tile are gathered once for all of
/// these families, and the sums of the tile are scattered after all of them have added to it.
struct FamilyGroup {
  Tiling tiling;
  std::vector<std::size_t> families;              // indices: first the family, then its riders
  std::uint32_t traits = 0;                       // bitwise or of the traits of active terms
  std::size_t first_tile = 0;                     // index of the first tile among the tiles of all groups
  std::vector<std::uint32_t> carried_tiles = {};  // tiles with nodes that a body carries
};

/// Puts families with the same nodes in a group. Groups are in the order of their first families, and do not
/// have tilings yet.
std::vector<FamilyGroup> find_family_groups(std::span<const std::unique_ptr<ElementFamily>> families);

}  // namespace netloft
