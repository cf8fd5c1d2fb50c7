// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "framework/balance/factorisation.hpp"

namespace netloft {

struct NodeGraph;

/// Methods to order nodes. `best` compares them.
enum class OrderingMethod { best, amd, metis };

/// An elimination order that keeps the factor sparse.
struct NodeOrdering {
  std::vector<std::int32_t> unknown;  // unknown[k] is the k-th unknown to be eliminated
  std::string method;                 // "METIS" or "AMD"
  double flops = 0;                   // operations of a Cholesky factorisation if every node had one unknown
};

/// The number of nodes from which on `best` tries METIS in addition to AMD. On nets of 100 to 600 nodes,
/// factorisations in the order of METIS took 1.02 to 1.7 times as many operations as in the order of AMD, and
/// METIS itself took as long as two factorisations.
inline constexpr std::int32_t kLargeNet = 700;

/// Orders the node graph of `pattern`. `best` tries both methods from `large` nodes on and takes the one with
/// fewer operations; for smaller nets it uses AMD only. Throws std::runtime_error if there is not enough
/// memory.
NodeOrdering order_nodes(const SparsePattern& pattern, OrderingMethod method = OrderingMethod::best,
                         std::int32_t large = kLargeNet);
/// Orders the nodes of a graph in the same way.
NodeOrdering order_nodes(const NodeGraph& graph, OrderingMethod method = OrderingMethod::best,
                         std::int32_t large = kLargeNet);

}  // namespace netloft
