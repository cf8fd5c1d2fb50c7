// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/family.hpp"
#include "framework/assembler/numbering.hpp"
#include "framework/assembler/sparse_pattern.hpp"

#include <memory>
#include <span>

namespace netloft {

/// The 3 x 3 blocks of node pairs in the array of matrix values. The nine values of a block are contiguous,
/// row by row, so that an element adds whole blocks: one look-up for nine values takes half the time of nine
/// look-ups. Blocks include rows and columns of held axes, although the sparsity pattern does not.
struct NodeBlocks {
  std::vector<std::size_t> column_start;  // first block of each column (node), and one past the last
  std::vector<std::uint32_t> row_node;    // row (node) of each block, ascending in a column

  std::size_t count() const { return row_node.size(); }
  /// Index of the first of the nine values of a block. The block must exist, with row >= column if the matrix
  /// is symmetric.
  std::size_t base(std::uint32_t row, std::uint32_t column) const;
};

/// Makes the blocks to which elements add. If the matrix is symmetric, these are only the blocks of the lower
/// triangle.
NodeBlocks make_blocks(std::span<const std::unique_ptr<ElementFamily>> families, const Scene& scene,
                       bool symmetric);

/// The entries of the matrix of the unknowns, only the lower triangle if symmetric. Each entry has a slot:
/// the index of its value in the array of blocks.
SparsePattern make_pattern(const NodeBlocks& blocks, const Numbering& numbering, bool symmetric);

/// Slot of (row, column), which must be in the pattern.
std::size_t find_slot(const SparsePattern& pattern, std::int32_t row, std::int32_t column);

}  // namespace netloft
