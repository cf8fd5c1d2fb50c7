// SPDX-License-Identifier: BSD-3-Clause
#include "io/result/dimensions.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::io {

namespace {

using Where = DimensionEnd::Where;

/// Nodes of a rope from its start to its end; none if there is no such rope.
std::vector<std::uint32_t> nodes_of_rope(const StoredResult& result, const std::string& name) {
  std::vector<std::uint32_t> nodes;
  const auto part = find_part(result, name);
  for (std::size_t i = 0; part && i < result.mesh.bars.size(); ++i) {
    if (result.mesh.cell_part[result.mesh.bar_cells[i]] != *part) continue;
    if (nodes.empty()) nodes.push_back(result.mesh.bars[i][0]);
    nodes.push_back(result.mesh.bars[i][1]);
  }
  return nodes;
}

/// The middle of a rope that goes from side to side; that of a half starts there.
std::uint32_t middle_of(const std::vector<std::uint32_t>& rope, bool is_half) {
  return rope[is_half ? 0 : rope.size() / 2];
}

Dimension spread_of(const std::string& name, const std::vector<std::uint32_t>& rope, bool is_half) {
  const DimensionEnd starboard{Where::node, rope.back()};
  return {name,
          is_half ? DimensionEnd{Where::mirrored, rope.back()} : DimensionEnd{Where::node, rope.front()},
          starboard};
}

/// Nodes that are held, and not by the plane of symmetry alone.
std::vector<std::uint32_t> held_nodes(const StoredResult& result) {
  const auto reaction = result.node_field("reaction", result.times.size() - 1);
  std::vector<std::uint32_t> held;
  for (std::uint32_t n = 0; 3 * n + 2 < reaction.size(); ++n)
    if (std::hypot(reaction[3 * n], reaction[3 * n + 2]) > 0) held.push_back(n);
  return held;
}

/// Between the points that a gear is towed at: one of a half, or two on both sides.
void add_towing_spread(const StoredResult& result, std::vector<Dimension>& all) {
  const auto held = held_nodes(result);
  if (held.size() == 1 && result.is_half)
    all.push_back({"spread of the towing points", {Where::mirrored, held[0]}, {Where::node, held[0]}});
  if (held.size() == 2 && !result.is_half)
    all.push_back({"spread of the towing points", {Where::node, held[0]}, {Where::node, held[1]}});
}

}  // namespace

std::vector<Dimension> dimensions_of(const StoredResult& result) {
  std::vector<Dimension> all;
  const auto headline = nodes_of_rope(result, result.headline),
             footrope = nodes_of_rope(result, result.footrope);
  if (headline.empty()) return all;
  const DimensionEnd top{Where::node, middle_of(headline, result.is_half)};
  if (result.bed)
    all.push_back({"headline height", top, {Where::bed, 0}});
  else if (!footrope.empty())
    all.push_back({"headline height", top, {Where::node, middle_of(footrope, result.is_half)}});
  all.push_back(spread_of("upper wing spread", headline, result.is_half));
  if (!footrope.empty()) all.push_back(spread_of("lower wing spread", footrope, result.is_half));
  add_towing_spread(result, all);
  return all;
}

std::array<double, 3> place_of(const DimensionEnd& end, const StoredResult& result,
                               const std::vector<double>& points, const std::array<double, 3>& other) {
  if (end.where == Where::bed && result.bed)
    return {other[0], other[1],
            result.bed->slope_x * other[0] + result.bed->slope_y * other[1] - result.bed->depth};
  const std::size_t at = 3 * std::size_t{end.node};
  return {points[at], (end.where == Where::mirrored ? -1 : 1) * points[at + 1], points[at + 2]};
}

}  // namespace netloft::io
