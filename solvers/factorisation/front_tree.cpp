// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/front_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>

#include "solvers/factorisation/front_kernels.hpp"
#include "solvers/factorisation/node_graph.hpp"
#include "solvers/factorisation/supernodes.hpp"

namespace netloft {
namespace {

using Indices = std::vector<std::int32_t>;

/// The vertices in the order of their first unknowns.
Indices vertex_order(const NodeGraph& graph, std::span<const std::int32_t> unknowns) {
  Indices vertex(graph.unknown.size()), order;
  for (std::int32_t v = 0; v < graph.size; ++v)
    for (std::int32_t k = graph.unknown_start[v]; k < graph.unknown_start[v + 1]; ++k)
      vertex[graph.unknown[k]] = v;
  for (const std::int32_t u : unknowns)
    if (graph.unknown[graph.unknown_start[vertex[u]]] == u) order.push_back(vertex[u]);
  return order;
}

/// Throws if a position in the panels of one front does not fit into 32 bits (FrontEntries::target).
void require_targets(std::size_t panels) {
  if (panels > std::numeric_limits<std::uint32_t>::max())
    throw std::runtime_error("cannot lay out a front of " + std::to_string(panels) +
                             " numbers, more than 2^32: the matrix is too dense");
}

class FrontTreeBuilder {
 public:
  explicit FrontTreeBuilder(const SparsePattern& pattern) : pattern_(pattern) {}

  FrontTree build(OrderingMethod method);

 private:
  void order_unknowns(const NodeGraph& graph, const Supernodes& supernodes);
  void list_fronts(const Supernodes& supernodes);
  void find_parents();
  void lay_out();
  void find_places();
  void number_locally(const Front& front);
  void list_runs();
  void list_pieces();
  void list_blocks();
  void sort_entries();
  void find_targets();
  bool are_a_node(std::int32_t unknown) const;
  bool have_same_rows(std::int32_t column) const;
  bool are_a_block(std::size_t entry, std::int32_t column) const;
  std::int32_t front_of_entry(std::int32_t row, std::int32_t column) const;
  void set_target(const Front& front, std::int32_t row, std::int32_t column, FrontEntries& entries) const;

  const SparsePattern& pattern_;
  FrontTree tree_;
  Indices vertex_start_;  // first unknown of each vertex by place, and the end of the last
  Indices place_;         // unknown -> k, its place in the order of elimination
  Indices front_;         // k -> front
  Indices local_;         // k -> place in the current front
  Indices row_, column_;  // row and column of the first entry of each FrontTree::of_matrix
  /// A block of entries of the matrix: 3 × 3 entries, or one.
  struct Piece {
    std::int32_t row, column;
    std::uint32_t slot;
    std::int32_t size;
  };
  std::vector<Piece> pieces_;        // pieces of all columns, column by column
  std::vector<bool> begins_a_node_;  // for each unknown: whether it and the next two belong to one node
};

FrontTree FrontTreeBuilder::build(OrderingMethod method) {
  const NodeGraph graph = make_node_graph(pattern_);
  NodeOrdering ordering = order_nodes(graph, method);
  const Supernodes supernodes(graph, vertex_order(graph, ordering.unknown));
  tree_.ordering = ordering.method;
  order_unknowns(graph, supernodes);
  list_fronts(supernodes);
  find_parents();
  lay_out();
  find_places();
  list_runs();
  list_pieces();
  list_blocks();
  sort_entries();
  find_targets();
  return std::move(tree_);
}

void FrontTreeBuilder::order_unknowns(const NodeGraph& graph, const Supernodes& supernodes) {
  vertex_start_.assign(1, 0);
  for (const std::int32_t v : supernodes.order()) {
    tree_.unknown.insert(tree_.unknown.end(), graph.unknown.begin() + graph.unknown_start[v],
                         graph.unknown.begin() + graph.unknown_start[v + 1]);
    vertex_start_.push_back(static_cast<std::int32_t>(tree_.unknown.size()));
  }
  place_.resize(tree_.unknown.size());
  for (std::size_t k = 0; k < place_.size(); ++k) place_[tree_.unknown[k]] = static_cast<std::int32_t>(k);
}

void FrontTreeBuilder::list_fronts(const Supernodes& supernodes) {
  front_.resize(tree_.unknown.size());
  for (std::size_t s = 0; s < supernodes.count(); ++s) {
    Front front;
    front.first = vertex_start_[supernodes.first(s)];
    front.pivots = vertex_start_[supernodes.first(s + 1)] - front.first;
    front.indices = tree_.other.size();
    for (const std::int32_t vertex : supernodes.others(s))
      for (std::int32_t k = vertex_start_[vertex]; k < vertex_start_[vertex + 1]; ++k)
        tree_.other.push_back(k);
    front.others = static_cast<std::int32_t>(tree_.other.size() - front.indices);
    std::fill_n(front_.begin() + front.first, front.pivots, static_cast<std::int32_t>(s));
    tree_.fronts.push_back(front);
  }
}

void FrontTreeBuilder::find_parents() {
  tree_.child_start.assign(tree_.fronts.size() + 1, 0);
  for (Front& front : tree_.fronts) {
    if (front.others == 0) continue;
    front.parent = front_[tree_.other[front.indices]];
    ++tree_.child_start[front.parent + 1];
  }
  std::partial_sum(tree_.child_start.begin(), tree_.child_start.end(), tree_.child_start.begin());
  tree_.child.resize(tree_.child_start.back());
  Indices next(tree_.child_start.begin(), tree_.child_start.end() - 1);
  for (std::size_t s = 0; s < tree_.fronts.size(); ++s)
    if (const std::int32_t parent = tree_.fronts[s].parent; parent >= 0)
      tree_.child[next[parent]++] = static_cast<std::int32_t>(s);
}

void FrontTreeBuilder::lay_out() {
  for (Front& front : tree_.fronts) {
    const double n = front.pivots, u = front.others;
    front.panels = tree_.panels;
    tree_.panels += static_cast<std::size_t>(
        front.pivots * (left_stride(front.pivots, front.others) + upper_stride(front.others)));
    tree_.most_unknowns = std::max(tree_.most_unknowns, front.pivots + front.others);
    tree_.entries += n * (n + 2 * u);
    tree_.flops += flops_of(front);
    require_targets(tree_.panels - front.panels);
  }
}

/// Numbers the unknowns of a front, pivots first.
void FrontTreeBuilder::number_locally(const Front& front) {
  std::iota(local_.begin() + front.first, local_.begin() + front.first + front.pivots, 0);
  for (std::int32_t i = 0; i < front.others; ++i) local_[tree_.other[front.indices + i]] = front.pivots + i;
}

void FrontTreeBuilder::find_places() {
  local_.assign(tree_.unknown.size(), 0);
  tree_.place.resize(tree_.other.size());
  for (std::size_t s = 0; s < tree_.fronts.size(); ++s) {
    const Front& front = tree_.fronts[s];
    number_locally(front);
    for (std::int32_t c = tree_.child_start[s]; c < tree_.child_start[s + 1]; ++c) {
      const Front& child = tree_.fronts[tree_.child[c]];
      for (std::size_t i = child.indices; i < child.indices + child.others; ++i)
        tree_.place[i] = local_[tree_.other[i]];
    }
  }
}

/// Lists runs of consecutive places. Pivots of the parent are not in one run with other unknowns.
void FrontTreeBuilder::list_runs() {
  for (Front& front : tree_.fronts) {
    front.runs = tree_.runs.size();
    const std::int32_t *place = tree_.place.data() + front.indices,
                       pivots = front.parent < 0 ? 0 : tree_.fronts[front.parent].pivots;
    for (std::int32_t i = 0; i < front.others; ++i)
      if (i > 0 && place[i] == place[i - 1] + 1 && place[i] != pivots)
        ++tree_.runs.back().count;
      else
        tree_.runs.push_back({i, place[i], 1});
  }
}

std::int32_t FrontTreeBuilder::front_of_entry(std::int32_t row, std::int32_t column) const {
  return front_[std::min(place_[row], place_[column])];
}

/// Whether this unknown and the next two belong to one node and are eliminated consecutively.
bool FrontTreeBuilder::are_a_node(std::int32_t unknown) const {
  if (unknown + 2 >= pattern_.size) return false;
  for (std::int32_t i : {1, 2})
    if (pattern_.node[unknown + i] != pattern_.node[unknown] || place_[unknown + i] != place_[unknown] + i ||
        front_[place_[unknown] + i] != front_[place_[unknown]])
      return false;
  return true;
}

/// Whether a column has the same rows as the two columns after it.
bool FrontTreeBuilder::have_same_rows(std::int32_t column) const {
  const auto rows = [&](std::int32_t c) {
    return std::span(pattern_.row.data() + pattern_.column_start[c],
                     pattern_.row.data() + pattern_.column_start[c + 1]);
  };
  return std::ranges::equal(rows(column), rows(column + 1)) &&
         std::ranges::equal(rows(column), rows(column + 2));
}

/// Whether an entry in the first of three columns begins a block of 3 × 3 entries.
bool FrontTreeBuilder::are_a_block(std::size_t entry, std::int32_t column) const {
  const std::int32_t count = pattern_.column_start[column + 1] - pattern_.column_start[column];
  if (entry + 2 >= static_cast<std::size_t>(pattern_.column_start[column + 1]) ||
      !begins_a_node_[pattern_.row[entry]])
    return false;
  for (std::int32_t i = 0; i < 3; ++i)
    for (std::int32_t j = 0; j < 3; ++j)
      if (pattern_.row[entry + i] != pattern_.row[entry] + i ||
          pattern_.slot_of(entry + i + j * count) !=
              pattern_.slot_of(entry) + static_cast<std::size_t>(3 * i + j))
        return false;
  return true;
}

/// Lists the entries of the matrix, in blocks if possible.
void FrontTreeBuilder::list_pieces() {
  begins_a_node_.resize(static_cast<std::size_t>(pattern_.size));
  for (std::int32_t u = 0; u < pattern_.size; ++u) begins_a_node_[u] = are_a_node(u);
  for (std::int32_t column = 0, columns = 1; column < pattern_.size; column += columns) {
    columns = begins_a_node_[column] && have_same_rows(column) ? 3 : 1;
    const std::int32_t begin = pattern_.column_start[column], end = pattern_.column_start[column + 1];
    const auto add = [&](std::int32_t entry, std::int32_t by, std::int32_t size) {
      const auto slot = pattern_.slot_of(entry + by * (end - begin));
      pieces_.push_back({pattern_.row[entry], column + by, static_cast<std::uint32_t>(slot), size});
    };
    for (std::int32_t entry = begin, rows = 1; entry < end; entry += rows) {
      rows = columns == 3 && are_a_block(entry, column) ? 3 : 1;
      if (rows == 3)
        add(entry, 0, 3);
      else
        for (std::int32_t by = 0; by < columns; ++by) add(entry, by, 1);
    }
  }
}

void FrontTreeBuilder::list_blocks() {
  MatrixBlocks& matrix = tree_.matrix;
  for (const auto& [row, column, slot, size] : pieces_) {
    if (size == 1) {
      matrix.entries.push_back({row, column, slot});
      continue;
    }
    if (matrix.columns.empty() || matrix.columns.back().column != column)
      matrix.columns.push_back({column, matrix.blocks.size()});
    matrix.blocks.push_back({row, slot});
  }
  matrix.columns.push_back({pattern_.size, matrix.blocks.size()});
}

void FrontTreeBuilder::sort_entries() {
  std::vector<std::size_t> next(tree_.fronts.size() + 1, 0);
  for (const Piece& piece : pieces_) ++next[front_of_entry(piece.row, piece.column) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t s = 0; s < tree_.fronts.size(); ++s) tree_.fronts[s].entries = next[s];
  Front end;
  end.entries = next.back();
  end.panels = tree_.panels;
  end.indices = tree_.other.size();
  end.runs = tree_.runs.size();
  tree_.of_matrix.resize(end.entries);
  row_.resize(end.entries);
  column_.resize(end.entries);
  for (const auto& [row, column, slot, size] : pieces_) {
    const std::size_t k = next[front_of_entry(row, column)]++;
    row_[k] = row;
    column_[k] = column;
    tree_.of_matrix[k].slot = slot;
    tree_.of_matrix[k].size = size;
  }
  tree_.fronts.push_back(end);
}

void FrontTreeBuilder::set_target(const Front& f, std::int32_t row, std::int32_t column,
                                  FrontEntries& entries) const {
  const std::int32_t i = local_[place_[row]], j = local_[place_[column]];
  const std::ptrdiff_t left = left_stride(f.pivots, f.others);
  const bool is_left = j < f.pivots;
  entries.target = static_cast<std::uint32_t>(
      is_left ? i + j * left : f.pivots * left + (j - f.pivots) + i * upper_stride(f.others));
  entries.down = is_left ? 1 : static_cast<std::int32_t>(upper_stride(f.others));
  entries.across = is_left ? static_cast<std::int32_t>(left) : 1;
}

void FrontTreeBuilder::find_targets() {
  for (std::size_t s = 0; s + 1 < tree_.fronts.size(); ++s) {
    const Front& front = tree_.fronts[s];
    number_locally(front);
    for (std::size_t k = front.entries; k < tree_.fronts[s + 1].entries; ++k)
      set_target(front, row_[k], column_[k], tree_.of_matrix[k]);
  }
}

}  // namespace

double flops_of(const Front& front) {
  const double n = front.pivots, u = front.others;
  return 2. / 3. * n * n * n + 2 * n * n * u + 2 * n * u * u;
}

FrontTree make_front_tree(const SparsePattern& pattern, OrderingMethod method) {
  return FrontTreeBuilder(pattern).build(method);
}

}  // namespace netloft
