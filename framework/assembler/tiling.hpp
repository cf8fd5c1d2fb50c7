// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/pattern.hpp"

#include <cstdint>
#include <vector>

namespace netloft {

/// A family cut into tiles of 64 consecutive elements, with the maps between a tile's lanes and the global
/// vectors. Tiles are coloured so that two of one colour share no node: those may be scattered at once, and
/// since colours go in order the sums have the same bits for any number of threads. (Colouring elements
/// instead of tiles would put lanes of one tile far apart in memory.)
struct Tiling {
  const Family* family = nullptr;
  std::size_t tiles = 0;
  std::vector<std::uint32_t> order;       // tiles, colour by colour
  std::vector<std::size_t> colour_begin;  // in `order`, +1
  std::vector<std::int32_t> vector_map;   // [tile][dof][64] -> place in vectors over all dofs
  std::vector<std::int32_t> matrix_map;  // [tile][entry][64] -> place in values; spare slots lie past the end
  std::size_t entries_per_element = 0;   // packed lower triangle, or the full square
  std::size_t first_spare = 0;           // slot of tile 0 for entries with a held row or column

  std::size_t lanes(std::size_t tile) const;
};

Tiling make_tiling(const Family& family, const Numbering& numbering, const SparsePattern& pattern,
                   std::size_t first_spare);

}  // namespace netloft
