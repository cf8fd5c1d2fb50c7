// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/element_tiles.hpp"

#include <algorithm>
#include <cassert>

namespace netloft {

const FamilyGroup& ElementTiles::group_of(std::size_t family) const {
  assert(family < group_at.size() && "each family is in a group");
  return groups[group_at[family]];
}

std::size_t ElementTiles::most_dofs() const {
  std::size_t dofs = 0;
  for (const auto& family : families) dofs = std::max(dofs, static_cast<std::size_t>(family->type().dofs()));
  return dofs;
}

ElementTiles make_element_tiles(std::span<const std::unique_ptr<ElementFamily>> families, const Scene& nodes,
                                const Numbering& numbering, const NodeBlocks& blocks,
                                const SparsePattern& pattern) {
  ElementTiles all{families, find_family_groups(families), std::vector<std::size_t>(families.size()), 0,
                   pattern.symmetric};
  for (std::size_t g = 0; g < all.groups.size(); ++g) {
    FamilyGroup& group = all.groups[g];
    for (const std::size_t family : group.families) all.group_at[family] = g;
    group.tiling = make_tiling(*families[group.families.front()], nodes, numbering, blocks, pattern.symmetric,
                               pattern.slots + 9 * all.count);
    group.first_tile = all.count;
    all.count += group.tiling.tiles;
    if (!nodes.bodies.empty()) group.carried_tiles = find_carried_tiles(group.tiling, nodes.carried);
  }
  all.values = pattern.slots + 9 * all.count;
  return all;
}

ElementTiles tiles_of(std::span<const std::unique_ptr<ElementFamily>> families, const ElementTiles& like) {
  ElementTiles all{families,   find_family_groups(families), like.group_at, like.count, like.symmetric,
                   like.values};
  for (std::size_t g = 0; g < all.groups.size(); ++g) {
    FamilyGroup& group = all.groups[g];
    group.tiling = like.groups[g].tiling;
    group.tiling.family = families[group.families.front()].get();
    group.first_tile = like.groups[g].first_tile;
    group.carried_tiles = like.groups[g].carried_tiles;
  }
  return all;
}

}  // namespace netloft
