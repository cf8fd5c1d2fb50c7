// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/riders.hpp"

#include <memory>
#include <span>
#include <vector>

namespace netloft {

/// All elements of a scene, in tiles of 64 elements. A family contains elements of one type only. Families on
/// the same nodes form a group and share the tiles of the group.
struct ElementTiles {
  std::span<const std::unique_ptr<ElementFamily>> families;
  std::vector<FamilyGroup> groups;
  std::vector<std::size_t> group_at;  // for each family: the index of its group
  std::size_t count = 0;              // tiles of all groups
  bool symmetric = true;              // matrices hold their lower triangle only
  // Length of the array of matrix values, including the spare blocks to which entries of held nodes are
  // added.
  std::size_t values = 0;

  const FamilyGroup& group_of(std::size_t family) const;
  /// The largest number of degrees of freedom of an element.
  std::size_t most_dofs() const;
};

/// `families` must outlive the tiles.
ElementTiles make_element_tiles(std::span<const std::unique_ptr<ElementFamily>> families, const Scene& nodes,
                                const Numbering& numbering, const NodeBlocks& blocks,
                                const SparsePattern& pattern);

/// Makes the tiles of `families` from `like`, the tiles of other families that have the same nodes.
ElementTiles tiles_of(std::span<const std::unique_ptr<ElementFamily>> families, const ElementTiles& like);

}  // namespace netloft
