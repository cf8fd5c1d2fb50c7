// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/node_graph.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>
#include <string>

namespace netloft {
namespace {

using Indices = std::vector<std::int32_t>;

/// Converts counts to start indices. The count of i must be stored at [i + 1].
void accumulate(Indices& start) { std::partial_sum(start.begin(), start.end(), start.begin()); }

/// Numbers the nodes that have unknowns, in the order of nodes; `vertices` becomes their number. Returns the
/// vertex of each unknown.
Indices number_vertices(const SparsePattern& pattern, std::int32_t& vertices) {
  const auto largest = std::max_element(pattern.node.begin(), pattern.node.end());
  Indices vertex_of_node(pattern.node.empty() ? 0 : *largest + 1, -1);
  for (const std::int32_t node : pattern.node) vertex_of_node[node] = 0;
  vertices = 0;
  for (std::int32_t& vertex : vertex_of_node) {
    if (vertex == 0) vertex = vertices++;
  }
  Indices vertex(pattern.node.size());
  std::transform(pattern.node.begin(), pattern.node.end(), vertex.begin(),
                 [&](std::int32_t node) { return vertex_of_node[node]; });
  return vertex;
}

void list_unknowns(const Indices& vertex, NodeGraph& graph) {
  graph.unknown_start.assign(graph.size + 1, 0);
  for (const std::int32_t v : vertex) ++graph.unknown_start[v + 1];
  accumulate(graph.unknown_start);
  graph.unknown.resize(vertex.size());
  Indices next = graph.unknown_start;
  for (std::size_t u = 0; u < vertex.size(); ++u) {
    graph.unknown[next[vertex[u]]++] = static_cast<std::int32_t>(u);
  }
}

struct Edge {
  std::int32_t low, high;
};

/// Lists the edges of each vertex. An edge may appear twice, once for each of its vertices.
std::vector<Edge> collect_edges(const SparsePattern& pattern, const Indices& vertex, const NodeGraph& graph) {
  std::vector<Edge> edges;
  Indices seen_from(graph.size, -1);
  for (std::int32_t v = 0; v < graph.size; ++v) {
    for (std::int32_t k = graph.unknown_start[v]; k < graph.unknown_start[v + 1]; ++k) {
      const std::int32_t u = graph.unknown[k];
      for (std::int32_t e = pattern.column_start[u]; e < pattern.column_start[u + 1]; ++e) {
        const std::int32_t w = vertex[pattern.row[e]];
        if (seen_from[w] == v) continue;
        seen_from[w] = v;
        edges.push_back({std::min(v, w), std::max(v, w)});
      }
    }
  }
  return edges;
}

/// Sorts the edges into columns by their lower vertex, then removes edges that appear twice.
void store_edges(const std::vector<Edge>& edges, NodeGraph& graph) {
  Indices start(graph.size + 1, 0);
  for (const Edge& edge : edges) ++start[edge.low + 1];
  accumulate(start);
  Indices high(edges.size());
  Indices next = start;
  for (const Edge& edge : edges) high[next[edge.low]++] = edge.high;

  Indices seen_from(graph.size, -1);
  graph.column_start.assign(1, 0);
  graph.row.reserve(edges.size());
  for (std::int32_t v = 0; v < graph.size; ++v) {
    for (std::int32_t e = start[v]; e < start[v + 1]; ++e) {
      if (seen_from[high[e]] == v) continue;
      seen_from[high[e]] = v;
      graph.row.push_back(high[e]);
    }
    graph.column_start.push_back(static_cast<std::int32_t>(graph.row.size()));
  }
}

/// Throws if there are too many edges. The format of METIS contains every edge twice, once for each end.
void require_indices(std::size_t edges, std::size_t most, std::int32_t nodes) {
  if (edges <= most) return;
  throw std::runtime_error("cannot order a matrix of " + std::to_string(nodes) +
                           " nodes: their graph has more than the " + std::to_string(most) +
                           " edges that METIS counts; a coarser mesh has fewer");
}

}  // namespace

NodeGraph make_node_graph(const SparsePattern& pattern, std::size_t most_edges) {
  assert(pattern.node.size() == static_cast<std::size_t>(pattern.size));
  NodeGraph graph;
  const Indices vertex = number_vertices(pattern, graph.size);
  list_unknowns(vertex, graph);
  const std::vector<Edge> edges = collect_edges(pattern, vertex, graph);
  require_indices(edges.size(), most_edges, graph.size);
  store_edges(edges, graph);
  require_indices(2 * graph.row.size(), most_edges, graph.size);
  return graph;
}

Neighbours neighbours_of(const NodeGraph& graph) {
  const auto for_edges = [&](auto&& visit) {
    for (std::int32_t v = 0; v < graph.size; ++v)
      for (std::int32_t e = graph.column_start[v]; e < graph.column_start[v + 1]; ++e)
        if (graph.row[e] != v) visit(v, graph.row[e]);
  };
  Neighbours all;
  all.start.assign(static_cast<std::size_t>(graph.size) + 1, 0);
  for_edges([&](std::int32_t low, std::int32_t high) {
    ++all.start[low + 1];
    ++all.start[high + 1];
  });
  accumulate(all.start);
  all.neighbour.resize(static_cast<std::size_t>(all.start.back()));
  Indices next = all.start;
  for_edges([&](std::int32_t low, std::int32_t high) { all.neighbour[next[high]++] = low; });
  for_edges([&](std::int32_t low, std::int32_t high) { all.neighbour[next[low]++] = high; });
  for (std::int32_t v = 0; v < graph.size; ++v)
    std::sort(all.neighbour.begin() + all.start[v], all.neighbour.begin() + all.start[v + 1]);
  return all;
}

}  // namespace netloft
