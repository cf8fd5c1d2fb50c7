// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/pattern.hpp"

#include <algorithm>

namespace netloft {

namespace {

using Neighbours = std::vector<std::vector<std::uint32_t>>;

/// Per node, the nodes that share an element with it, itself included, ascending.
Neighbours find_neighbours(std::span<const std::unique_ptr<Family>> families, std::size_t nodes) {
  Neighbours near(nodes);
  for (const auto& family : families)
    for (std::size_t e = 0; e < family->size(); ++e)
      for (int i = 0; i < family->nodes_per_element(); ++i)
        for (int j = 0; j < family->nodes_per_element(); ++j)
          near[family->node(e, i)].push_back(family->node(e, j));
  for (std::size_t n = 0; n < nodes; ++n) {
    near[n].push_back(static_cast<std::uint32_t>(n));
    std::sort(near[n].begin(), near[n].end());
    near[n].erase(std::unique(near[n].begin(), near[n].end()), near[n].end());
  }
  return near;
}

void append_column(SparsePattern& pattern, const Numbering& numbering, const std::vector<std::uint32_t>& near,
                   std::int32_t column) {
  for (const auto node : near)
    for (int axis = 0; axis < 3; ++axis) {
      const std::int32_t row = numbering.index(node, axis);
      if (numbering.is_unknown(row) && (!pattern.symmetric || row >= column)) pattern.row.push_back(row);
    }
  pattern.column_start.push_back(static_cast<std::int32_t>(pattern.row.size()));
}

}  // namespace

SparsePattern make_pattern(std::span<const std::unique_ptr<Family>> families, const Numbering& numbering,
                           std::size_t nodes, bool symmetric) {
  const Neighbours near = find_neighbours(families, nodes);
  SparsePattern pattern;
  pattern.size = numbering.unknowns();
  pattern.symmetric = symmetric;
  pattern.column_start.push_back(0);
  for (std::int32_t column = 0; column < pattern.size; ++column) {
    const std::uint32_t node = numbering.node(column);
    pattern.node.push_back(static_cast<std::int32_t>(node));
    append_column(pattern, numbering, near[node], column);
  }
  return pattern;
}

std::size_t find_entry(const SparsePattern& pattern, std::int32_t row, std::int32_t column) {
  const auto begin = pattern.row.begin() + pattern.column_start[static_cast<std::size_t>(column)];
  const auto end = pattern.row.begin() + pattern.column_start[static_cast<std::size_t>(column) + 1];
  return static_cast<std::size_t>(std::lower_bound(begin, end, row) - pattern.row.begin());
}

}  // namespace netloft
