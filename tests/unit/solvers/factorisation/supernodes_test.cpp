// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/supernodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "solvers/factorisation/elimination_tree.hpp"

namespace netloft {
namespace {

using Indices = std::vector<std::int32_t>;

/// A graph with random edges, each stored once, with the diagonal.
NodeGraph random_graph(std::int32_t size, int edges, std::mt19937& random) {
  std::vector<std::set<std::int32_t>> higher(static_cast<std::size_t>(size));
  for (std::int32_t v = 0; v < size; ++v) higher[v].insert(v);
  for (int e = 0; e < edges; ++e) {
    const auto a = static_cast<std::int32_t>(random() % size), b = static_cast<std::int32_t>(random() % size);
    higher[std::min(a, b)].insert(std::max(a, b));
  }
  NodeGraph graph;
  graph.size = size;
  graph.column_start = {0};
  for (const auto& rows : higher) {
    graph.row.insert(graph.row.end(), rows.rbegin(), rows.rend());
    graph.column_start.push_back(static_cast<std::int32_t>(graph.row.size()));
  }
  return graph;
}

Indices random_order(std::int32_t size, std::mt19937& random) {
  Indices order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::shuffle(order, random);
  return order;
}

/// The columns of L when vertices are eliminated one by one: the later neighbours of each vertex become
/// neighbours of each other.
std::vector<std::set<std::int32_t>> eliminate(const NodeGraph& graph, const Indices& order) {
  Indices place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<std::int32_t>(k);
  std::vector<std::set<std::int32_t>> columns(order.size());
  for (std::int32_t v = 0; v < graph.size; ++v)
    for (std::int32_t e = graph.column_start[v]; e < graph.column_start[v + 1]; ++e) {
      const auto [early, late] = std::minmax(place[v], place[graph.row[e]]);
      columns[early].insert(late);
    }
  for (auto& column : columns)
    if (column.size() > 1) {
      const std::int32_t next = *std::next(column.begin());
      columns[next].insert(std::next(column.begin()), column.end());
    }
  return columns;
}

TEST(EliminationTree, HasTheColumnsOfTheElimination) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const std::int32_t size = 1 + i % 40;
    const NodeGraph graph = random_graph(size, i % 80, random);
    const Indices order = random_order(size, random);
    const EliminationTree tree = make_elimination_tree(graph, order);
    const auto columns = eliminate(graph, order);
    double flops = 0;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      ASSERT_EQ(tree.count[k], static_cast<std::int32_t>(columns[k].size()));
      ASSERT_EQ(tree.parent[k], columns[k].size() > 1 ? *std::next(columns[k].begin()) : -1);
      flops += static_cast<double>(columns[k].size() * columns[k].size());
    }
    EXPECT_EQ(tree.flops(), flops);
  }
}

TEST(EliminationTree, HasSubtreesInOnePieceAfterPostorder) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const std::int32_t size = 1 + i % 40;
    const EliminationTree tree =
        make_elimination_tree(random_graph(size, size, random), random_order(size, random));
    const Indices order = postorder(tree);
    Indices place(order.size(), -1);
    for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<std::int32_t>(k);
    ASSERT_EQ(std::ranges::count(place, -1), 0);
    Indices first(place), members(order.size(), 1);  // of each subtree, by place
    for (std::int32_t k = 0; k < size; ++k) first[k] = k;
    for (std::int32_t k = 0; k < size; ++k) {
      ASSERT_EQ(k - first[k] + 1, members[k]);
      if (tree.parent[order[k]] < 0) continue;
      const std::int32_t parent = place[tree.parent[order[k]]];
      ASSERT_GT(parent, k);
      first[parent] = std::min(first[parent], first[k]);
      members[parent] += members[k];
    }
  }
}

TEST(Supernodes, HoldTheColumnsOfTheElimination) {
  std::mt19937 random(1);
  std::size_t merged = 0;
  for (int i = 0; i < 200; ++i) {
    const std::int32_t size = 1 + i % 60;
    const NodeGraph graph = random_graph(size, i % 100, random);
    const Supernodes supernodes(graph, random_order(size, random));
    const auto columns = eliminate(graph, supernodes.order());
    ASSERT_EQ(supernodes.first(0), 0);
    ASSERT_EQ(supernodes.first(supernodes.count()), size);
    for (std::size_t s = 0; s < supernodes.count(); ++s) {
      const auto others = supernodes.others(s);
      std::set<std::int32_t> expected;  // rows that the columns of the front have beyond the front
      for (std::int32_t k = supernodes.first(s); k < supernodes.first(s + 1); ++k)
        expected.insert(columns[k].lower_bound(supernodes.first(s + 1)), columns[k].end());
      ASSERT_TRUE(std::ranges::equal(others, expected)) << i;
    }
    merged += static_cast<std::size_t>(size) - supernodes.count();
  }
  EXPECT_GT(merged, 1000u);
}

// A path is eliminated from one end to the other: every column but the last has two entries. At least the
// last two columns are merged, because that adds no zeros.
TEST(Supernodes, MergeAFrontWithItsParentWhereThatCostsLittle) {
  NodeGraph dense{4, {0, 4, 7, 9, 10}, {0, 1, 2, 3, 1, 2, 3, 2, 3, 3}, {}, {}};
  EXPECT_EQ(Supernodes(dense, Indices{2, 0, 3, 1}).count(), 1u);
  NodeGraph apart{4, {0, 1, 2, 3, 4}, {0, 1, 2, 3}, {}, {}};
  EXPECT_EQ(Supernodes(apart, Indices{2, 0, 3, 1}).count(), 4u);
  NodeGraph path{4, {0, 2, 4, 6, 7}, {0, 1, 1, 2, 2, 3, 3}, {}, {}};
  EXPECT_LT(Supernodes(path, Indices{0, 1, 2, 3}).count(), 4u);
}

}  // namespace
}  // namespace netloft
