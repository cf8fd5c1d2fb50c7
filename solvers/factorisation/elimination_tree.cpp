// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/elimination_tree.hpp"

#include <algorithm>
#include <numeric>

namespace netloft {
namespace {

using Indices = std::vector<std::int32_t>;

/// For each vertex, its neighbours that come before it in the order: the rows of the matrix below the
/// diagonal. Vertices are named by their places in the order.
class EarlierNeighbours {
 public:
  EarlierNeighbours(const NodeGraph& graph, std::span<const std::int32_t> order)
      : start_(order.size() + 1, 0) {
    Indices place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<std::int32_t>(k);
    for_edges(graph, place, [&](std::int32_t, std::int32_t late) { ++start_[late + 1]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    earlier_.resize(start_.back());
    Indices next(start_.begin(), start_.end() - 1);
    for_edges(graph, place, [&](std::int32_t early, std::int32_t late) { earlier_[next[late]++] = early; });
  }

  std::span<const std::int32_t> of(std::int32_t k) const {
    return std::span(earlier_).subspan(start_[k], start_[k + 1] - start_[k]);
  }

 private:
  template <class Visit>
  static void for_edges(const NodeGraph& graph, const Indices& place, Visit&& visit) {
    for (std::int32_t v = 0; v < graph.size; ++v)
      for (std::int32_t e = graph.column_start[v]; e < graph.column_start[v + 1]; ++e)
        if (graph.row[e] != v) {
          const auto [early, late] = std::minmax(place[v], place[graph.row[e]]);
          visit(early, late);
        }
  }

  Indices start_, earlier_;
};

}  // namespace

double EliminationTree::flops() const {
  return std::accumulate(count.begin(), count.end(), 0.0,
                         [](double sum, double entries) { return sum + entries * entries; });
}

EliminationTree make_elimination_tree(const NodeGraph& graph, std::span<const std::int32_t> order) {
  const EarlierNeighbours neighbours(graph, order);
  EliminationTree tree{Indices(order.size(), -1), Indices(order.size(), 1)};
  Indices row(order.size(), -1);  // the last row of L with an entry in each column
  // Row k of L has entries in all columns on the paths that lead from the neighbours of vertex k upwards in
  // the tree of the vertices before k.
  for (std::int32_t k = 0; k < graph.size; ++k) {
    row[k] = k;
    for (std::int32_t column : neighbours.of(k))
      for (; row[column] != k; column = tree.parent[column]) {
        row[column] = k;
        ++tree.count[column];
        if (tree.parent[column] < 0) tree.parent[column] = k;
      }
  }
  return tree;
}

std::vector<std::int32_t> postorder(const EliminationTree& tree) {
  const auto size = static_cast<std::int32_t>(tree.parent.size());
  Indices by_count(tree.parent.size());
  std::iota(by_count.begin(), by_count.end(), 0);
  std::ranges::stable_sort(by_count, {}, [&](std::int32_t k) { return tree.count[k]; });
  // The children of each vertex, as linked lists that begin with the largest child; the last list has the
  // roots.
  Indices first(tree.parent.size() + 1, -1), next(tree.parent.size(), -1);
  for (const std::int32_t k : by_count) {
    std::int32_t& head = first[tree.parent[k] < 0 ? size : tree.parent[k]];
    next[k] = head;
    head = k;
  }
  // This visits parents before children, and the largest child first: the reverse of the wanted order.
  Indices order, open;
  for (std::int32_t root = first[size]; root >= 0; root = next[root]) open.push_back(root);
  std::ranges::reverse(open);
  while (!open.empty()) {
    const std::int32_t k = open.back();
    open.pop_back();
    order.push_back(k);
    const auto children = static_cast<std::ptrdiff_t>(open.size());
    for (std::int32_t child = first[k]; child >= 0; child = next[child]) open.push_back(child);
    std::reverse(open.begin() + children, open.end());
  }
  std::ranges::reverse(order);
  return order;
}

}  // namespace netloft
