// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/supernodes.hpp"

#include <algorithm>
#include <iterator>

#include "solvers/factorisation/elimination_tree.hpp"

namespace netloft {
namespace {

using Indices = std::vector<std::int32_t>;

/// Consecutive supernodes that are merged into one with `columns` columns. Its first column has `rows`
/// entries; `zeros` of all entries are zeros.
struct Merged {
  std::int32_t first = 0;
  double columns = 0, rows = 0, zeros = 0;

  double entries() const { return columns * (columns + 1) / 2 + columns * (rows - columns); }
};

/// Returns both as one supernode. `child` must come directly before `parent`; its columns then get entries in
/// all rows of `parent`.
Merged merged(const Merged& child, const Merged& parent) {
  Merged both{child.first, child.columns + parent.columns, child.columns + parent.rows, 0};
  both.zeros = both.entries() - (child.entries() - child.zeros) - (parent.entries() - parent.zeros);
  return both;
}

/// Two neighbouring supernodes are merged into one of n vertices if n ≤ 2, or if the fraction of zeros among
/// its entries is at most 0.8 (n ≤ 6), 0.1 (n ≤ 16) or 0.05 (any n). Seven sets of limits were compared, from
/// no merging to (6, 16, 32; 0.8, 0.2, 0.08), on tangents of 500 to 10⁵ unknowns. No other set is better by
/// more than 4 %, and the one with the largest supernodes takes 1.5 times as long for 500 unknowns.
bool is_worth_merging(const Merged& both) {
  constexpr double kVertices[] = {2, 6, 16};
  constexpr double kZeros[] = {0.8, 0.1, 0.05};
  const double zeros = both.zeros / both.entries();
  return both.columns <= kVertices[0] || (both.columns <= kVertices[1] && zeros <= kZeros[0]) ||
         (both.columns <= kVertices[2] && zeros <= kZeros[1]) || zeros <= kZeros[2];
}

/// The first vertices of supernodes whose columns have the same entries.
Indices find_equal_columns(const EliminationTree& tree) {
  Indices children(tree.parent.size(), 0), first;
  for (const std::int32_t p : tree.parent)
    if (p >= 0) ++children[p];
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(tree.parent.size()); ++k) {
    const bool goes_on =
        k > 0 && tree.parent[k - 1] == k && tree.count[k - 1] == tree.count[k] + 1 && children[k] == 1;
    if (!goes_on) first.push_back(k);
  }
  return first;
}

/// Goes through the supernodes from the last to the first. Merges each with the next one, if the next one is
/// its parent and merging is worthwhile.
Indices merge(const EliminationTree& tree, const Indices& first) {
  const auto size = static_cast<std::int32_t>(tree.parent.size());
  std::vector<Merged> rows;  // from the last to the first
  for (std::size_t s = first.size(); s-- > 0;) {
    const std::int32_t end = s + 1 < first.size() ? first[s + 1] : size;
    const Merged own{first[s], static_cast<double>(end - first[s]), static_cast<double>(tree.count[first[s]]),
                     0};
    if (!rows.empty() && tree.parent[end - 1] >= end &&
        tree.parent[end - 1] < end + static_cast<std::int32_t>(rows.back().columns)) {
      if (const Merged both = merged(own, rows.back()); is_worth_merging(both)) {
        rows.back() = both;
        continue;
      }
    }
    rows.push_back(own);
  }
  Indices starts;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) starts.push_back(row->first);
  starts.push_back(size);
  return starts;
}

}  // namespace

Supernodes::Supernodes(const NodeGraph& graph, std::span<const std::int32_t> order) {
  for (const std::int32_t k : postorder(make_elimination_tree(graph, order))) order_.push_back(order[k]);
  const EliminationTree tree = make_elimination_tree(graph, order_);
  first_ = merge(tree, find_equal_columns(tree));
  find_others(graph);
}

/// Finds the `others` of every supernode: the later neighbours of its vertices, and the `others` of its
/// children.
void Supernodes::find_others(const NodeGraph& graph) {
  Indices place(order_.size()), supernode(order_.size()), seen_from(order_.size(), -1);
  for (std::size_t k = 0; k < order_.size(); ++k) place[order_[k]] = static_cast<std::int32_t>(k);
  for (std::size_t s = 0; s < count(); ++s)
    std::fill(supernode.begin() + first_[s], supernode.begin() + first_[s + 1], static_cast<std::int32_t>(s));
  std::vector<Indices> others(count());
  const auto couple = [&](std::int32_t s, std::int32_t later) {
    if (later < first_[s + 1] || seen_from[later] == s) return;
    seen_from[later] = s;
    others[s].push_back(later);
  };
  std::vector<std::vector<std::int32_t>> children(count());
  // The graph has each edge once. Therefore each edge is first given to the supernode of its earlier end.
  std::vector<Indices> later(count());
  for (std::int32_t v = 0; v < graph.size; ++v)
    for (std::int32_t e = graph.column_start[v]; e < graph.column_start[v + 1]; ++e) {
      const auto [early, late] = std::minmax(place[v], place[graph.row[e]]);
      later[supernode[early]].push_back(late);
    }
  start_.assign(1, 0);
  for (std::size_t s = 0; s < count(); ++s) {
    const auto own = static_cast<std::int32_t>(s);
    for (const std::int32_t k : later[s]) couple(own, k);
    for (const std::int32_t child : children[s])
      for (const std::int32_t k : others[child]) couple(own, k);
    std::ranges::sort(others[s]);
    if (!others[s].empty()) children[supernode[others[s].front()]].push_back(own);
    others_.insert(others_.end(), others[s].begin(), others[s].end());
    start_.push_back(others_.size());
  }
}

}  // namespace netloft
