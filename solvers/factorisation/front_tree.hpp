// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "framework/balance/factorisation.hpp"
#include "solvers/factorisation/matrix_kernels.hpp"
#include "solvers/factorisation/node_ordering.hpp"

namespace netloft {

/// A dense step of the elimination of a matrix: it eliminates n pivots, which are coupled to u other unknowns
/// at that step.
struct Front {
  std::int32_t first = 0;    // first pivot of the front, in the order of elimination
  std::int32_t pivots = 0;   // number n of pivots
  std::int32_t others = 0;   // number u of other unknowns
  std::int32_t parent = -1;  // front that eliminates the first of the other unknowns
  // Indices of the first number of the front in each list:
  std::size_t indices = 0;  // other unknowns, in FrontTree::other and FrontTree::place
  std::size_t panels = 0;   // panels, in the factors
  std::size_t runs = 0;     // runs of other unknowns, in FrontTree::runs
  std::size_t entries = 0;  // entries of the matrix, in FrontTree::of_matrix
};

/// Operations that the elimination of a front takes.
double flops_of(const Front& front);

/// Entries of the matrix that are added to a front at its start: one entry, or the 3 × 3 entries of a pair of
/// nodes, whose slots (positions among the values of the matrix) are adjacent row by row.
struct FrontEntries {
  std::uint32_t slot = 0;             // slot of the first entry
  std::uint32_t target = 0;           // position in the panels of the front to which the first entry is added
  std::int32_t down = 0, across = 0;  // distance in the panels to the next row, and to the next column
  std::int32_t size = 1;              // number of rows and of columns
};

/// The elimination, front by front, of a matrix with a symmetric pattern (Duff and Reid 1983). Every front
/// sums its entries of the matrix and the updates of its children, eliminates its pivots, and passes the
/// update
///   C = Σ C_child − L₂₁ U₁₂                                               (1)
/// to its parent; L₂₁ and U₁₂ are the parts of its factors outside the pivots (front_kernels.hpp). Children
/// come before parents, and the fronts of each subtree are numbered consecutively.
struct FrontTree {
  std::vector<std::int32_t> unknown;  // unknown[k] is the k-th unknown to be eliminated
  std::vector<Front> fronts;          // all fronts, and an additional one that marks the end
  std::vector<std::int32_t> other;    // unknowns of each front that are not its pivots, by place, ascending
  std::vector<std::int32_t> place;    // place of each `other` among the unknowns of the parent, pivots first
  std::vector<UnknownRun> runs;       // the entries of `place`, as runs of consecutive places
  std::vector<std::int32_t> child_start, child;
  std::vector<FrontEntries> of_matrix;  // entries of all fronts, front by front
  MatrixBlocks matrix;
  std::size_t panels = 0;          // size of all panels [doubles]
  std::int32_t most_unknowns = 0;  // largest number of unknowns of a front
  double entries = 0, flops = 0;   // entries of the factors, operations to compute them
  std::string ordering;
};

/// Orders `pattern`, merges small fronts (supernodes.hpp), and computes all indices. Throws
/// std::runtime_error on failure.
FrontTree make_front_tree(const SparsePattern& pattern, OrderingMethod method);

}  // namespace netloft
