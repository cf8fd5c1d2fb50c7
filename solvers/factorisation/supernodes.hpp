// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solvers/factorisation/node_graph.hpp"

namespace netloft {

/// Vertices of a graph that are eliminated together, because they are coupled to the same or nearly the same
/// other vertices: relaxed supernodes (Ashcraft and Grimes, ACM Trans. Math. Softw. 15 (1989) 291).
class Supernodes {
 public:
  /// The vertices are eliminated in `order`, or in another order with the same fill.
  Supernodes(const NodeGraph& graph, std::span<const std::int32_t> order);

  std::size_t count() const { return first_.size() - 1; }
  /// The vertices in the order in which they are eliminated. Elsewhere, a vertex is named by its place in
  /// this order.
  const std::vector<std::int32_t>& order() const { return order_; }
  /// The first vertex of a supernode, or the number of all vertices for s = count().
  std::int32_t first(std::size_t s) const { return first_[s]; }
  /// The later vertices to which the vertices of a supernode are coupled, ascending.
  std::span<const std::int32_t> others(std::size_t s) const {
    return std::span(others_).subspan(start_[s], start_[s + 1] - start_[s]);
  }

 private:
  void find_others(const NodeGraph& graph);

  std::vector<std::int32_t> order_, first_, others_;
  std::vector<std::size_t> start_;
};

}  // namespace netloft
