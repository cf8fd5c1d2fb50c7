// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/pattern.hpp"

#include "framework/assembler/matrix_size.hpp"
#include "framework/assembler/riders.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>

namespace netloft {

namespace {

/// Adds the pairs of nodes that bodies couple. The origin and the rotation of a body are coupled to all
/// neighbours of the body's points, and the points of one body are neighbours of each other.
template <class Add>
void join_bodies(const Scene& scene, const Add& add, const std::vector<std::vector<std::uint32_t>>& near) {
  if (scene.bodies.empty()) return;
  std::vector<std::vector<std::uint32_t>> stands_for(scene.node_count());
  for (std::uint32_t n = 0; n < scene.node_count(); ++n) stands_for[n] = {n};
  for (const auto& body : scene.bodies)
    for (const auto& point : body.points) stands_for[point.node] = {body.origin, body.rotation_node};
  const auto found = near;  // a copy of the neighbours due to elements, because `add` changes `near`
  for (std::uint32_t column = 0; column < found.size(); ++column)
    for (const auto row : found[column])
      for (const auto a : stands_for[row])
        for (const auto b : stands_for[column]) {
          add(b, a);
          add(a, b);
        }
}

/// For each node, the nodes that can move and share an element with it, itself included.
std::vector<std::vector<std::uint32_t>> find_neighbours(
    std::span<const std::unique_ptr<ElementFamily>> families, const Scene& scene, bool symmetric) {
  constexpr std::size_t kMostly = 32;  // more entries per node, with repetitions, than most nodes have
  std::vector<std::vector<std::uint32_t>> near(scene.node_count());
  for (auto& rows : near) rows.reserve(kMostly);
  const auto moves = [&](std::uint32_t node) { return !scene.stands_still(node); };
  const auto add = [&](std::uint32_t column, std::uint32_t row) {
    if (moves(row) && moves(column) && (!symmetric || row >= column)) near[column].push_back(row);
  };
  for (std::uint32_t n = 0; n < scene.node_count(); ++n) add(n, n);
  for (const FamilyGroup& group : find_family_groups(families)) {
    const ElementFamily& family = *families[group.families.front()];
    for (std::size_t e = 0; e < family.size(); ++e)
      for (int i = 0; i < family.all_nodes_per_element(); ++i)
        for (int j = 0; j < family.all_nodes_per_element(); ++j)
          if (i != j) add(family.node(e, i), family.node(e, j));
  }
  join_bodies(scene, add, near);
  for (auto& rows : near) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  }
  return near;
}

}  // namespace

std::size_t NodeBlocks::base(std::uint32_t row, std::uint32_t column) const {
  const auto begin = row_node.begin() + static_cast<std::ptrdiff_t>(column_start[column]);
  const auto end = row_node.begin() + static_cast<std::ptrdiff_t>(column_start[column + 1]);
  const auto at = std::lower_bound(begin, end, row);
  assert(at != end && *at == row && "some element has both nodes");
  return 9 * static_cast<std::size_t>(at - row_node.begin());
}

NodeBlocks make_blocks(std::span<const std::unique_ptr<ElementFamily>> families, const Scene& scene,
                       bool symmetric) {
  NodeBlocks blocks;
  blocks.column_start.push_back(0);
  for (const auto& rows : find_neighbours(families, scene, symmetric)) {
    blocks.row_node.insert(blocks.row_node.end(), rows.begin(), rows.end());
    blocks.column_start.push_back(blocks.row_node.size());
  }
  return blocks;
}

void require_indices(std::size_t blocks) {
  if (blocks > kMostValues / 9)
    throw std::length_error("the matrix has " + std::to_string(blocks) + " pairs of nodes, but at most " +
                            std::to_string(kMostValues / 9) + " are possible; a coarser mesh has fewer");
}

SparsePattern make_pattern(const NodeBlocks& blocks, const Numbering& numbering, bool symmetric) {
  require_indices(blocks.count());
  SparsePattern pattern;
  pattern.size = numbering.unknowns();
  pattern.symmetric = symmetric;
  pattern.slots = 9 * blocks.count();
  pattern.row.reserve(pattern.slots);
  pattern.slot.reserve(pattern.slots);
  pattern.column_start.push_back(0);
  for (std::int32_t column = 0; column < pattern.size; ++column) {
    const std::uint32_t node = numbering.node(Dof(column));
    pattern.node.push_back(static_cast<std::int32_t>(node));
    for (std::size_t b = blocks.column_start[node]; b < blocks.column_start[node + 1]; ++b)
      for (int axis = 0; axis < 3; ++axis) {
        const Dof row = numbering.dof(blocks.row_node[b], axis);
        if (!numbering.is_unknown(row) || (symmetric && row < Dof(column))) continue;
        pattern.row.push_back(row.place);
        pattern.slot.push_back(static_cast<std::int32_t>(9 * b) + 3 * axis + numbering.axis(Dof(column)));
      }
    pattern.column_start.push_back(static_cast<std::int32_t>(pattern.row.size()));
  }
  return pattern;
}

std::size_t find_slot(const SparsePattern& pattern, std::int32_t row, std::int32_t column) {
  const auto begin = pattern.row.begin() + pattern.column_start[static_cast<std::size_t>(column)];
  const auto end = pattern.row.begin() + pattern.column_start[static_cast<std::size_t>(column) + 1];
  const auto at = std::lower_bound(begin, end, row);
  assert(at != end && *at == row && "the entry is in the pattern");
  return pattern.slot_of(static_cast<std::size_t>(at - pattern.row.begin()));
}

}  // namespace netloft
