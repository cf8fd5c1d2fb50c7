// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/node_ordering.hpp"

#include <stdexcept>

#include "solvers/factorisation/node_graph.hpp"
#include "solvers/factorisation/suitesparse_scope.hpp"

namespace netloft {
namespace {

std::vector<std::int32_t> expand_to_unknowns(const NodeGraph& graph, const int* vertex_order) {
  std::vector<std::int32_t> unknowns;
  unknowns.reserve(graph.unknown.size());
  for (std::int32_t k = 0; k < graph.size; ++k) {
    const auto first = graph.unknown.begin() + graph.unknown_start[vertex_order[k]];
    const auto last = graph.unknown.begin() + graph.unknown_start[vertex_order[k] + 1];
    unknowns.insert(unknowns.end(), first, last);
  }
  return unknowns;
}

NodeOrdering order_by(int method, const char* name, NodeGraph& graph) {
  CholmodCommon common;
  common->nmethods = 1;
  common->method[0].ordering = method;
  common->supernodal = CHOLMOD_SIMPLICIAL;
  cholmod_sparse view = view_of(graph);
  cholmod_factor* factor = cholmod_analyze(&view, common.get());
  if (factor == nullptr) {
    throw std::runtime_error(std::string("cannot order the matrix by ") + name + ": CHOLMOD status " +
                             std::to_string(common->status));
  }
  NodeOrdering ordering{expand_to_unknowns(graph, static_cast<const int*>(factor->Perm)), name, common->fl};
  cholmod_free_factor(&factor, common.get());
  return ordering;
}

}  // namespace

NodeOrdering order_nodes(const SparsePattern& pattern, OrderingMethod method, std::int32_t worth_metis) {
  const SingleThreadScope single_thread;
  NodeGraph graph = make_node_graph(pattern);
  if (method == OrderingMethod::best && graph.size < worth_metis) method = OrderingMethod::amd;
  if (method == OrderingMethod::amd) return order_by(CHOLMOD_AMD, "AMD", graph);
  NodeOrdering metis = order_by(CHOLMOD_METIS, "METIS", graph);
  if (method == OrderingMethod::metis) return metis;
  NodeOrdering amd = order_by(CHOLMOD_AMD, "AMD", graph);
  return amd.flops < metis.flops ? amd : metis;
}

}  // namespace netloft
