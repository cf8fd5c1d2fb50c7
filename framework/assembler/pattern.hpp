// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/family.hpp"
#include "framework/assembler/numbering.hpp"
#include "framework/assembler/sparse_pattern.hpp"

#include <memory>
#include <span>

namespace netloft {

/// The positions of the 3 x 3 blocks of node pairs in the array of matrix values. The nine values of a block
/// are contiguous, row by row, so that an element adds whole blocks: one look-up for nine values (half the
/// time of the scatter, compared with one look-up per value). Blocks include rows and columns of held axes,
/// which are not in the pattern.
struct NodeBlocks {
  std::vector<std::size_t> column_start;  // per node, +1
  std::vector<std::uint32_t> row_node;    // ascending in a column

  std::size_t count() const { return row_node.size(); }
  /// Index of the first of the nine values of a block, which must exist; row >= column if the matrix is
  /// symmetric.
  std::size_t base(std::uint32_t row, std::uint32_t column) const;
};

/// The blocks to which the elements of all families can add; only lower ones if symmetric.
NodeBlocks make_blocks(std::span<const std::unique_ptr<ElementFamily>> families, const Scene& scene,
                       bool symmetric);

/// The entries of the unknowns within the blocks, only the lower triangle if symmetric, each with its slot.
SparsePattern make_pattern(const NodeBlocks& blocks, const Numbering& numbering, bool symmetric);

/// Slot of (row, column), which must be in the pattern.
std::size_t find_slot(const SparsePattern& pattern, std::int32_t row, std::int32_t column);

}  // namespace netloft
