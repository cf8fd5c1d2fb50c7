// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/pattern.hpp"

#include <cstdint>
#include <vector>

namespace netloft {

/// A family (all elements of one type) cut into tiles of 64 consecutive elements, with the maps between a
/// tile's lanes and the global vectors. Two tiles of one colour have no node in common, so that two threads
/// may scatter them at the same time. Colours are processed in order, so that sums are bit-identical for any
/// number of threads. (If elements were coloured instead of tiles, the nodes of one tile would be far apart
/// in memory.)
struct Tiling {
  /// Two corners of an element that are the same node, for instance where netting is gathered to a point.
  /// Block (P, Q) and its transpose (Q, P) then both belong to the diagonal block of this node, but an
  /// element stores only one of them.
  struct Twin {
    std::uint32_t lane;
    int P, Q;
  };

  const ElementFamily* family = nullptr;
  std::size_t tiles = 0;
  std::vector<std::uint32_t> order;       // tiles, colour by colour
  std::vector<std::size_t> colour_begin;  // first tile of each colour in `order`, and one past the last
  std::vector<std::int32_t> vector_map;   // [tile][dof][64] -> index in vectors over all dofs
  std::vector<std::int32_t>
      block_map;  // [tile][block][64] -> index of the first of nine values; ~index: add the transpose
  std::vector<std::vector<Twin>> twins;  // twins of each tile, if the matrix is symmetric; mostly empty
  std::size_t blocks_per_element = 0;    // number of pairs of corners (P, Q), Q <= P if symmetric
  // Index of the first spare block of the array of matrix values. Each tile has one spare block, which
  // collects the entries of held nodes.
  std::size_t first_spare = 0;

  std::size_t lanes(std::size_t tile) const;
};

/// Tiles with a node that a body carries.
std::vector<std::uint32_t> find_carried_tiles(const Tiling& tiling, const std::vector<bool>& carried);

Tiling make_tiling(const ElementFamily& family, const Scene& scene, const Numbering& numbering,
                   const NodeBlocks& blocks, bool symmetric, std::size_t first_spare);

}  // namespace netloft
