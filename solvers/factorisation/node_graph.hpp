// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "framework/balance/factorisation.hpp"

namespace netloft {

/// A sparsity pattern in which the unknowns of each node are merged into one vertex. An ordering of this
/// graph has the same fill as one of the full pattern, which has nine times as many edges.
struct NodeGraph {
  std::int32_t size = 0;  // number of vertices: nodes that have an unknown

  // The edges between vertices, diagonal included. Each is stored once, with row ≥ column; rows are not
  // sorted.
  std::vector<std::int32_t> column_start;
  std::vector<std::int32_t> row;

  // Unknowns of vertex v: unknown[unknown_start[v]], …, unknown[unknown_start[v + 1] - 1], ascending.
  std::vector<std::int32_t> unknown_start;
  std::vector<std::int32_t> unknown;
};

/// Largest number of edges, where an edge counts once at each end. METIS uses 32-bit indices.
inline constexpr std::size_t kMostEdges = 0x7fffffff;

/// Makes the graph of a pattern. An unsymmetric pattern is first united with its transpose. Throws
/// std::runtime_error with a sentence if there are more than `most_edges` edges.
NodeGraph make_node_graph(const SparsePattern& pattern, std::size_t most_edges = kMostEdges);

/// The neighbours of each vertex v, without v itself: neighbour[start[v]], …, neighbour[start[v + 1] - 1],
/// ascending.
struct Neighbours {
  std::vector<std::int32_t> start, neighbour;
};
Neighbours neighbours_of(const NodeGraph& graph);

}  // namespace netloft
