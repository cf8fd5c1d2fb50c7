// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solvers/factorisation/node_graph.hpp"

namespace netloft {

/// The elimination tree of a graph whose vertices are eliminated in a given order (Liu, SIAM J. Matrix Anal.
/// Appl. 11 (1990) 134). Vertices are named by their places in this order.
struct EliminationTree {
  std::vector<std::int32_t>
      parent;  // the first later vertex to which a vertex is coupled when it is eliminated; -1: none
  std::vector<std::int32_t> count;  // number of entries in the column of L, including the diagonal

  /// Operations of a Cholesky factorisation if every vertex had one unknown.
  double flops() const;
};

/// `order[k]` is the k-th vertex to be eliminated. The time is proportional to the number of entries of L.
EliminationTree make_elimination_tree(const NodeGraph& graph, std::span<const std::int32_t> order);

/// An order of the vertices of a tree in which every subtree is contiguous, children come before parents, and
/// the child with the largest column comes last. The fill is the same as before, and the data that children
/// pass to parents can be kept on a stack.
std::vector<std::int32_t> postorder(const EliminationTree& tree);

}  // namespace netloft
