// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/node_ordering.hpp"

#include <amd.h>
#include <metis.h>

#include <numeric>
#include <stdexcept>

#include "solvers/factorisation/elimination_tree.hpp"
#include "solvers/factorisation/node_graph.hpp"

namespace netloft {
namespace {

using Indices = std::vector<std::int32_t>;

static_assert(sizeof(idx_t) == sizeof(std::int32_t), "METIS is built for indices of 64 bits");

Indices expand_to_unknowns(const NodeGraph& graph, const Indices& vertex_order) {
  Indices unknowns;
  unknowns.reserve(graph.unknown.size());
  for (const std::int32_t v : vertex_order)
    unknowns.insert(unknowns.end(), graph.unknown.begin() + graph.unknown_start[v],
                    graph.unknown.begin() + graph.unknown_start[v + 1]);
  return unknowns;
}

void require_done(bool is_done, const char* name, int status) {
  if (!is_done)
    throw std::runtime_error(std::string("cannot order the matrix by ") + name + ": status " +
                             std::to_string(status));
}

/// If there are no edges, all orders are equally good, and neither library accepts the graph.
Indices order_vertices(OrderingMethod method, Neighbours& graph, std::int32_t size) {
  Indices order(static_cast<std::size_t>(size)), place(order.size());
  std::iota(order.begin(), order.end(), 0);
  if (graph.neighbour.empty()) return order;
  std::int32_t *start = graph.start.data(), *neighbour = graph.neighbour.data();
  if (method == OrderingMethod::metis) {
    const int status = METIS_NodeND(&size, start, neighbour, nullptr, nullptr, order.data(), place.data());
    require_done(status == METIS_OK, "METIS", status);
  } else {
    const int status = amd_order(size, start, neighbour, order.data(), nullptr, nullptr);
    require_done(status == AMD_OK, "AMD", status);
  }
  return order;
}

NodeOrdering order_by(OrderingMethod method, const NodeGraph& graph, Neighbours& neighbours) {
  const Indices order = order_vertices(method, neighbours, graph.size);
  return {expand_to_unknowns(graph, order), method == OrderingMethod::metis ? "METIS" : "AMD",
          make_elimination_tree(graph, order).flops()};
}

}  // namespace

NodeOrdering order_nodes(const SparsePattern& pattern, OrderingMethod method, std::int32_t large) {
  return order_nodes(make_node_graph(pattern), method, large);
}

NodeOrdering order_nodes(const NodeGraph& graph, OrderingMethod method, std::int32_t large) {
  Neighbours neighbours = neighbours_of(graph);
  if (method != OrderingMethod::best) return order_by(method, graph, neighbours);
  NodeOrdering amd = order_by(OrderingMethod::amd, graph, neighbours);
  if (graph.size < large) return amd;
  NodeOrdering metis = order_by(OrderingMethod::metis, graph, neighbours);
  return amd.flops < metis.flops ? amd : metis;
}

}  // namespace netloft
