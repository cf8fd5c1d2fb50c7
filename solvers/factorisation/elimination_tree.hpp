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
      parent;  // first vertex after it to which a vertex is coupled when it is eliminated; -1: none
  std::vector<std::int32_t>
      count;  // vertices to which it is coupled then, with itself: entries of its column of L

  /// Operations of a Cholesky factorisation if every vertex had one unknown.
  double flops() const;
};

/// `order[k]` is the vertex that is eliminated as the k-th. The time is that of the entries of L.
EliminationTree make_elimination_tree(const NodeGraph& graph, std::span<const std::int32_t> order);

/// An order of the vertices of a tree in which each subtree is in one piece, children before parents, the
/// child with the largest column last. With it, the fill stays the same, and a stack holds what is passed
/// from children to parents.
std::vector<std::int32_t> postorder(const EliminationTree& tree);

}  // namespace netloft
