// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "framework/problem/factorisation.hpp"
#include "solvers/factorisation/matrix_kernels.hpp"
#include "solvers/factorisation/node_ordering.hpp"

namespace netloft {

/// A dense piece of the elimination: n pivots, and the u other unknowns that they are coupled with by then.
struct Front {
  std::int32_t first = 0;    // of its pivots, in the order of elimination
  std::int32_t pivots = 0;   // n
  std::int32_t others = 0;   // u
  std::int32_t parent = -1;  // front of the first of the others
  std::size_t indices = 0;   // of the others, in FrontTree::other and FrontTree::place
  std::size_t panels = 0;    // in the factors
  std::size_t update = 0;    // in the stack of its parity
  std::size_t runs = 0;      // of the others, in FrontTree::runs
  std::size_t entries = 0;   // of the matrix, in FrontTree::of_matrix
};

/// Entries of the matrix that a front begins with: one, or nine of three rows and columns, whose slots are
/// neighbours row by row, as a pair of nodes has them.
struct FrontEntries {
  std::uint32_t slot = 0;             // of the first
  std::uint32_t target = 0;           // its place in the panels of its front
  std::int32_t down = 0, across = 0;  // from there to the next row, and to the next column
  std::int32_t size = 1;              // rows and columns
};

/// How a matrix of symmetric pattern is eliminated front by front (Duff and Reid 1983): every front adds up
/// its entries of the matrix and what its children leave, eliminates its pivots, and leaves
///   C = Σ C_child − L₂₁ U₁₂                                               (1)
/// to its parent. Children come before parents. Updates lie on two stacks, by the parity of a front's depth:
/// children are on top of the one when their parent pushes its own onto the other.
struct FrontTree {
  std::vector<std::int32_t> unknown;  // unknown[k] is eliminated as the k-th
  std::vector<Front> fronts;          // and one more, where all ends
  std::vector<std::int32_t> other;    // unknowns of each front that are not its pivots, by place, ascending
  std::vector<std::int32_t> place;    // of each of them among the unknowns of its parent, pivots first
  std::vector<UnknownRun> runs;       // of the same, by the front of which they are the others
  std::vector<std::int32_t> child_start, child;
  std::vector<std::uint8_t> parity;     // of the depth of each front
  std::vector<FrontEntries> of_matrix;  // by fronts
  MatrixBlocks matrix;
  std::size_t panels = 0, stack[2]{};  // doubles
  std::int32_t most_unknowns = 0;      // of a front
  double entries = 0, flops = 0;       // of the factors
  std::string ordering;
};

/// Orders `pattern`, draws small fronts together as CHOLMOD does its supernodes, and works out where
/// everything goes. Throws std::runtime_error when it cannot.
FrontTree make_front_tree(const SparsePattern& pattern, OrderingMethod method);

}  // namespace netloft
