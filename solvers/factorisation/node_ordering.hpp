// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "framework/balance/factorisation.hpp"

namespace netloft {

struct NodeGraph;

/// `dissection`: METIS's separators one by one, then within and between them by constrained minimum degree.
enum class OrderingMethod { best, amd, metis, dissection };

/// An elimination order that keeps the factor sparse.
struct NodeOrdering {
  std::vector<std::int32_t> unknown;  // unknown[k] is eliminated as the k-th
  std::string method;                 // "METIS", "AMD" or "METIS and CAMD"
  double flops = 0;                   // of a Cholesky factorisation of the node graph, one number per node
};

/// The method that `best` tries besides AMD, and the number of nodes from which it does. On nets of 100 to
/// 600 nodes METIS gave factorisations of 1.02 to 1.7 times the operations, and took as long as two of them.
struct LargeNets {
  std::int32_t nodes = 700;
  OrderingMethod method = OrderingMethod::metis;
};

/// Orders the node graph of `pattern`; `best` tries two methods and takes the one with fewer operations; for
/// nets that are not large it uses AMD alone. Throws std::runtime_error when the memory runs out.
NodeOrdering order_nodes(const SparsePattern& pattern, OrderingMethod method = OrderingMethod::best,
                         LargeNets large = {});
/// The same for an existing graph.
NodeOrdering order_nodes(NodeGraph& graph, OrderingMethod method = OrderingMethod::best,
                         LargeNets large = {});

}  // namespace netloft
