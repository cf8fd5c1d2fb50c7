// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/node_ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "solvers/factorisation/finite_values.hpp"
#include "solvers/factorisation/node_graph.hpp"
#include "tests/unit/solvers/factorisation/net_matrix.hpp"

namespace netloft {
namespace {

using Indices = std::vector<std::int32_t>;

// Unknowns 0, 2 at node 7, unknown 1 at node 3, unknown 3 at node 9; entries 0-2, 1-2, 2-3.
SparsePattern small_pattern() {
  return {4, {0, 2, 4, 6, 7}, {0, 2, 1, 2, 2, 3, 3}, {7, 3, 7, 9}, true, {}, 0};
}

Indices sorted_column(const NodeGraph& graph, int vertex) {
  Indices rows(graph.row.begin() + graph.column_start[vertex],
               graph.row.begin() + graph.column_start[vertex + 1]);
  std::sort(rows.begin(), rows.end());
  return rows;
}

bool is_permutation_of(Indices order, std::int32_t size) {
  Indices natural(size);
  std::iota(natural.begin(), natural.end(), 0);
  std::sort(order.begin(), order.end());
  return order == natural;
}

TEST(NodeGraph, DrawsTheUnknownsOfANodeTogether) {
  const NodeGraph graph = make_node_graph(small_pattern());
  ASSERT_EQ(graph.size, 3);  // nodes 3, 7, 9 in this order
  EXPECT_EQ(graph.unknown_start, (Indices{0, 1, 3, 4}));
  EXPECT_EQ(graph.unknown, (Indices{1, 0, 2, 3}));
  EXPECT_EQ(sorted_column(graph, 0), (Indices{0, 1}));
  EXPECT_EQ(sorted_column(graph, 1), (Indices{1, 2}));
  EXPECT_EQ(sorted_column(graph, 2), (Indices{2}));
}

TEST(NodeGraph, IsTheSameForTheFullPatternAndTheLowerTriangle) {
  NetOptions options{.rings = 5, .nodes_per_ring = 4};
  const NodeGraph lower = make_node_graph(make_net_matrix(options).pattern);
  options.symmetric = false;
  const NodeGraph full = make_node_graph(make_net_matrix(options).pattern);
  ASSERT_EQ(lower.size, 20);
  ASSERT_EQ(lower.column_start, full.column_start);
  for (int v = 0; v < lower.size; ++v) EXPECT_EQ(sorted_column(lower, v), sorted_column(full, v));
}

TEST(NodeGraph, IsRefusedWhereItHasMoreEdgesThanMetisCounts) {
  const SparsePattern pattern = small_pattern();  // 3 nodes: diagonal entries and two edges
  EXPECT_EQ(make_node_graph(pattern, 10).size, 3);
  try {
    make_node_graph(pattern, 9);
    FAIL() << "a graph with too many edges was accepted";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("more than the 9 edges that METIS counts"), std::string::npos);
  }
}

TEST(NodeGraph, OfNothingIsEmpty) {
  const NodeGraph graph = make_node_graph({0, {0}, {}, {}, true, {}, 0});
  EXPECT_EQ(graph.size, 0);
  EXPECT_TRUE(graph.row.empty());
}

TEST(NodeOrdering, EliminatesEveryUnknownOnceByEachMethod) {
  const TestMatrix net =
      make_net_matrix({.is_fixed = [](int node, int axis) { return (node + axis) % 4 == 0; }});
  for (const OrderingMethod method : {OrderingMethod::amd, OrderingMethod::metis, OrderingMethod::best})
    EXPECT_TRUE(is_permutation_of(order_nodes(net.pattern, method).unknown, net.pattern.size));
}

TEST(NodeOrdering, KeepsTheUnknownsOfANodeTogether) {
  const TestMatrix net = make_net_matrix({});
  const NodeOrdering ordering = order_nodes(net.pattern);
  for (std::size_t k = 0; k < ordering.unknown.size(); k += 3) {
    EXPECT_EQ(net.pattern.node[ordering.unknown[k]], net.pattern.node[ordering.unknown[k + 2]]);
  }
}

TEST(NodeOrdering, TakesTheMethodWithFewerOperations) {
  for (const int rings : {10, 100}) {
    const TestMatrix net = make_net_matrix({.rings = rings, .nodes_per_ring = 100});
    const double amd = order_nodes(net.pattern, OrderingMethod::amd).flops;
    const double metis = order_nodes(net.pattern, OrderingMethod::metis).flops;
    EXPECT_EQ(order_nodes(net.pattern).flops, std::min(amd, metis));
  }
}

TEST(NodeOrdering, TriesMetisOnlyWhereItIsWorthIt) {
  const TestMatrix net = make_net_matrix({.rings = 100, .nodes_per_ring = 100});
  const NodeOrdering tried = order_nodes(net.pattern, OrderingMethod::best, 10'000);
  EXPECT_EQ(tried.method, "METIS");
  EXPECT_LT(tried.flops, order_nodes(net.pattern, OrderingMethod::amd).flops);
  EXPECT_EQ(order_nodes(net.pattern, OrderingMethod::best, 10'001).method, "AMD");
}

TEST(NodeOrdering, ManagesNodesThatTouchNoOther) {
  const SparsePattern loose{3, {0, 1, 2, 3}, {0, 1, 2}, {0, 1, 2}, true, {}, 0};
  for (const OrderingMethod method : {OrderingMethod::amd, OrderingMethod::metis})
    EXPECT_TRUE(is_permutation_of(order_nodes(loose, method).unknown, 3));
}

TEST(FiniteValues, NamesTheColumnOfTheFirstThatIsNot) {
  const SparsePattern pattern = small_pattern();
  std::vector<double> values(pattern.entries(), 1.0);
  EXPECT_EQ(find_column_not_finite(pattern, values), -1);
  values[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(find_column_not_finite(pattern, values), 2);
  values[3] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(find_column_not_finite(pattern, values), 1);
}

}  // namespace
}  // namespace netloft
