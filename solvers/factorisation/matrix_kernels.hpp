// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>

#include "solvers/factorisation/front_kernels.hpp"

namespace netloft {

/// A matrix in blocks of 3 × 3 values. The nine values of a block are contiguous, row by row.
struct MatrixBlocks {
  struct Column {
    std::int32_t column;  // index of the first of three columns
    std::size_t first;    // index of its first block
  };
  struct Block {
    std::int32_t row;  // first of three rows
    std::uint32_t slot;
  };
  struct Entry {
    std::int32_t row, column;
    std::uint32_t slot;
  };
  std::vector<Column> columns;  // columns of blocks, and one more that marks the end
  std::vector<Block> blocks;
  std::vector<Entry> entries;  // entries outside blocks
};

/// Unknowns that are consecutive in a front and also in its parent front. Either all or none of them are
/// pivots of the parent.
struct UnknownRun {
  std::int32_t from = 0;   // first unknown of the run among the others of the front
  std::int32_t place = 0;  // place of this unknown among the unknowns of the parent
  std::int32_t count = 0;
};

/// The update of a child front: its columns, whose stride is that of the child's `upper` panel, and the
/// places of its rows and columns in the parent.
struct ChildUpdate {
  const double* C;
  std::int32_t others;
  std::span<const UnknownRun> runs;
};

/// Operations on numbers of the matrix and of fronts, for the instruction set of this processor.
struct MatrixKernels {
  /// Adds the update of a child to the panels of a front, and to the update C of the front, which has the
  /// stride of `upper`.
  void (*add_child)(const ChildUpdate& child, const FrontPanels& front, double* C);
  /// Copies `from` to `to`. Returns false if some numbers are not finite.
  bool (*take)(std::span<const double> from, double* to);
  /// Computes A x and |A| |x|. Row i of each product is the sum of the three numbers from index 3 i on.
  void (*multiply)(const MatrixBlocks& A, const double* values, std::span<const double> x, double* products,
                   double* sizes);
};

/// matrix_kernels() returns the best kernels for this processor, matrix_kernels_here() all kernels that run
/// on it, the best last.
const MatrixKernels& matrix_kernels();
std::vector<MatrixKernels> matrix_kernels_here();

}  // namespace netloft
