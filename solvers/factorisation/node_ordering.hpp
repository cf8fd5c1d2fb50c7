// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "framework/balance/factorisation.hpp"

namespace netloft {

struct NodeGraph;

/// Methods to order nodes. `best` compares several. With `dissection`, METIS separates the graph recursively;
/// then constrained minimum degree (CAMD) orders the nodes of the pieces and of the separators.
enum class OrderingMethod { best, amd, metis, dissection };

/// An elimination order that keeps the factor sparse.
struct NodeOrdering {
  std::vector<std::int32_t> unknown;  // unknown[k] is eliminated as the k-th
  std::string method;                 // "METIS", "AMD" or "METIS and CAMD"
  double flops = 0;                   // operations of a Cholesky factorisation if every node had one unknown
};

/// The method that `best` tries in addition to AMD for nets of at least so many nodes. On nets of 100 to 600
/// nodes, factorisations after METIS had 1.02 to 1.7 times the operations of those after AMD, and METIS took
/// as long as two factorisations.
struct LargeNets {
  std::int32_t nodes = 700;
  OrderingMethod method = OrderingMethod::metis;
};

/// Orders the node graph of `pattern`. `best` tries two methods for large nets and takes the one with fewer
/// operations; for smaller nets it uses AMD only. Throws std::runtime_error if there is not enough memory.
NodeOrdering order_nodes(const SparsePattern& pattern, OrderingMethod method = OrderingMethod::best,
                         LargeNets large = {});
/// Orders the nodes of a graph in the same way.
NodeOrdering order_nodes(NodeGraph& graph, OrderingMethod method = OrderingMethod::best,
                         LargeNets large = {});

}  // namespace netloft
