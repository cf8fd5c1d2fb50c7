// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/front_tree.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <stdexcept>

#include "solvers/factorisation/front_kernels.hpp"
#include "solvers/factorisation/node_graph.hpp"
#include "solvers/factorisation/suitesparse_scope.hpp"

namespace netloft {
namespace {

using Indices = std::vector<std::int32_t>;

/// CHOLMOD's supernodes of the node graph.
class Supernodes {
 public:
  Supernodes(NodeGraph& graph, Indices order);
  ~Supernodes() { cholmod_free_factor(&factor_, common_.get()); }
  Supernodes(const Supernodes&) = delete;
  Supernodes& operator=(const Supernodes&) = delete;

  std::size_t count() const { return factor_->nsuper; }
  std::span<const int> order() const { return {static_cast<const int*>(factor_->Perm), factor_->n}; }
  int first(std::size_t s) const { return static_cast<const int*>(factor_->super)[s]; }
  /// Vertices, by place, its own first.
  std::span<const int> vertices(std::size_t s) const {
    const int *start = static_cast<const int*>(factor_->pi), *vertex = static_cast<const int*>(factor_->s);
    return {vertex + start[s], vertex + start[s + 1]};
  }

 private:
  CholmodCommon common_;
  cholmod_factor* factor_ = nullptr;
};

/// Neighbouring supernodes become one of n vertices if n ≤ 2, or n ≤ 6 with at most a share of 0.8 of zeros,
/// or n ≤ 16 with 0.1, or with 0.05. Of seven sets between none at all and 6, 16, 32, 0.8, 0.2, 0.08 no other
/// is better by more than 4 % on tangents of 500 to 10⁵ unknowns; the largest takes 1.5 times as long at 500.
void merge(cholmod_common& common) {
  constexpr std::size_t kVertices[] = {2, 6, 16};
  constexpr double kZeros[] = {0.8, 0.1, 0.05};
  std::copy(std::begin(kVertices), std::end(kVertices), common.nrelax);
  std::copy(std::begin(kZeros), std::end(kZeros), common.zrelax);
}

Supernodes::Supernodes(NodeGraph& graph, Indices order) {
  common_->nmethods = 1;
  common_->method[0].ordering = CHOLMOD_GIVEN;
  common_->supernodal = CHOLMOD_SUPERNODAL;
  merge(*common_.get());
  cholmod_sparse view = view_of(graph);
  factor_ = cholmod_analyze_p(&view, order.data(), nullptr, 0, common_.get());
  if (factor_ == nullptr) {
    throw std::runtime_error("cannot analyse a matrix of " + std::to_string(graph.unknown.size()) +
                             " unknowns: CHOLMOD status " + std::to_string(common_->status));
  }
}

/// The vertices in the order of the first of their unknowns.
Indices vertex_order(const NodeGraph& graph, std::span<const std::int32_t> unknowns) {
  Indices vertex(graph.unknown.size()), order;
  for (std::int32_t v = 0; v < graph.size; ++v)
    for (std::int32_t k = graph.unknown_start[v]; k < graph.unknown_start[v + 1]; ++k)
      vertex[graph.unknown[k]] = v;
  for (const std::int32_t u : unknowns)
    if (graph.unknown[graph.unknown_start[vertex[u]]] == u) order.push_back(vertex[u]);
  return order;
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
  void stack_updates();
  void find_places();
  void number_locally(const Front& front);
  void list_columns();
  bool follows(std::int32_t column, std::int32_t first) const;
  void sort_rows();
  void find_targets();
  template <class Visit>
  void for_rows(const Visit& visit) const;
  std::int32_t front_of_entry(std::int32_t row, std::int32_t column) const;
  void set_target(const Front& front, std::int32_t row, std::int32_t column, ShortRow& entries) const;

  const SparsePattern& pattern_;
  FrontTree tree_;
  Indices vertex_start_;  // by place: first unknown of each vertex, and where all end
  Indices place_;         // unknown -> k
  Indices front_;         // k -> front
  Indices local_;         // k -> place in the front at hand
  Indices row_, column_;  // of the short rows, by fronts
};

FrontTree FrontTreeBuilder::build(OrderingMethod method) {
  NodeGraph graph = make_node_graph(pattern_);
  NodeOrdering ordering = order_nodes(graph, method);
  const SingleThreadScope single_thread;
  const Supernodes supernodes(graph, vertex_order(graph, ordering.unknown));
  tree_.ordering = ordering.method;
  order_unknowns(graph, supernodes);
  list_fronts(supernodes);
  find_parents();
  lay_out();
  stack_updates();
  find_places();
  list_columns();
  sort_rows();
  find_targets();
  return std::move(tree_);
}

void FrontTreeBuilder::order_unknowns(const NodeGraph& graph, const Supernodes& supernodes) {
  vertex_start_.assign(1, 0);
  for (const int v : supernodes.order()) {
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
    const std::size_t own = static_cast<std::size_t>(supernodes.first(s + 1) - supernodes.first(s));
    Front front;
    front.first = vertex_start_[supernodes.first(s)];
    front.pivots = vertex_start_[supernodes.first(s + 1)] - front.first;
    front.indices = tree_.other.size();
    for (const int vertex : supernodes.vertices(s).subspan(own))
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
    tree_.flops += 2. / 3. * n * n * n + 2 * n * n * u + 2 * n * u * u;
  }
}

void FrontTreeBuilder::stack_updates() {
  auto& fronts = tree_.fronts;
  tree_.parity.resize(fronts.size());
  for (std::size_t s = fronts.size(); s-- > 0;)
    tree_.parity[s] = fronts[s].parent < 0 ? 0 : 1 - tree_.parity[fronts[s].parent];
  std::size_t top[2]{};
  for (std::size_t s = 0; s < fronts.size(); ++s) {
    std::size_t &own = top[tree_.parity[s]], &below = top[1 - tree_.parity[s]];
    fronts[s].update = own;
    own += static_cast<std::size_t>(fronts[s].others * upper_stride(fronts[s].others));
    for (int parity : {0, 1}) tree_.stack[parity] = std::max(tree_.stack[parity], top[parity]);
    for (std::int32_t c = tree_.child_start[s]; c < tree_.child_start[s + 1]; ++c)
      below = std::min(below, fronts[tree_.child[c]].update);
  }
}

/// Pivots first.
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

std::int32_t FrontTreeBuilder::front_of_entry(std::int32_t row, std::int32_t column) const {
  return front_[std::min(place_[row], place_[column])];
}

/// Three columns of one node stand in the same rows, and their slots are neighbours.
void FrontTreeBuilder::list_columns() {
  for (std::int32_t column = 0; column < pattern_.size;) {
    tree_.columns.push_back(column);
    const bool three =
        column + 2 < pattern_.size && follows(column + 1, column) && follows(column + 2, column);
    column += three ? 3 : 1;
  }
  tree_.columns.push_back(pattern_.size);
}

/// In the order of elimination, too.
bool FrontTreeBuilder::follows(std::int32_t column, std::int32_t first) const {
  const std::int32_t by = column - first, k = place_[first], begin = pattern_.column_start[column],
                     start = pattern_.column_start[first], count = pattern_.column_start[first + 1] - start;
  if (pattern_.column_start[column + 1] - begin != count || place_[column] != k + by ||
      front_[k + by] != front_[k])
    return false;
  for (std::int32_t e = 0; e < count; ++e)
    if (pattern_.row[begin + e] != pattern_.row[start + e] ||
        pattern_.slot_of(begin + e) != pattern_.slot_of(start + e) + static_cast<std::size_t>(by))
      return false;
  return true;
}

template <class Visit>
void FrontTreeBuilder::for_rows(const Visit& visit) const {
  for (std::size_t c = 0; c + 1 < tree_.columns.size(); ++c) {
    const std::int32_t column = tree_.columns[c], columns = tree_.columns[c + 1] - column;
    for (std::int32_t e = pattern_.column_start[column]; e < pattern_.column_start[column + 1]; ++e)
      visit(static_cast<std::size_t>(e), pattern_.row[e], column, columns);
  }
}

/// By fronts.
void FrontTreeBuilder::sort_rows() {
  std::vector<std::size_t> next(tree_.fronts.size() + 1, 0);
  for_rows([&](auto, auto row, auto column, auto) { ++next[front_of_entry(row, column) + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t s = 0; s < tree_.fronts.size(); ++s) tree_.fronts[s].rows = next[s];
  Front end;
  end.rows = next.back(), end.panels = tree_.panels, end.indices = tree_.other.size();
  tree_.rows.resize(end.rows), row_.resize(end.rows), column_.resize(end.rows);
  for_rows([&](std::size_t e, auto row, auto column, auto columns) {
    const std::size_t k = next[front_of_entry(row, column)]++;
    row_[k] = row, column_[k] = column;
    tree_.rows[k] = {static_cast<std::uint32_t>(pattern_.slot_of(e)), 0, 0, columns};
  });
  tree_.fronts.push_back(end);
}

void FrontTreeBuilder::set_target(const Front& f, std::int32_t row, std::int32_t column,
                                  ShortRow& entries) const {
  const std::int32_t i = local_[place_[row]], j = local_[place_[column]];
  const std::ptrdiff_t left = left_stride(f.pivots, f.others);
  const bool is_left = j < f.pivots;
  entries.target = static_cast<std::uint32_t>(
      is_left ? i + j * left : f.pivots * left + (j - f.pivots) + i * upper_stride(f.others));
  entries.stride = is_left ? static_cast<std::int32_t>(left) : 1;
}

void FrontTreeBuilder::find_targets() {
  for (std::size_t s = 0; s + 1 < tree_.fronts.size(); ++s) {
    const Front& front = tree_.fronts[s];
    number_locally(front);
    for (std::size_t k = front.rows; k < tree_.fronts[s + 1].rows; ++k)
      set_target(front, row_[k], column_[k], tree_.rows[k]);
  }
}

}  // namespace

FrontTree make_front_tree(const SparsePattern& pattern, OrderingMethod method) {
  return FrontTreeBuilder(pattern).build(method);
}

}  // namespace netloft
