// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/share.hpp"

#include <algorithm>

namespace netloft {

namespace {

template <class Visit>
void visit_nodes(const Tiling& tiling, std::size_t tile, const Visit& visit) {
  const ElementFamily& family = *tiling.family;
  for (std::size_t lane = 0; lane < tiling.lanes(tile); ++lane)
    for (int n = 0; n < family.all_nodes_per_element(); ++n)
      visit(family.node(tile * NETLOFT_LANES + lane, n));
}

/// Per node the entries of all element matrices that have it as a corner.
std::vector<double> weigh_nodes(std::span<const FamilyGroup> groups, std::size_t nodes) {
  std::vector<double> weights(nodes, 0.0);
  for (const FamilyGroup& group : groups) {
    const double corners = group.tiling.family->all_nodes_per_element();
    for (std::size_t tile = 0; tile < group.tiling.tiles; ++tile)
      visit_nodes(group.tiling, tile, [&](std::uint32_t node) {
        weights[node] += corners * static_cast<double>(group.families.size());
      });
  }
  return weights;
}

std::vector<Range> cut(const std::vector<double>& weights, std::size_t count) {
  double all = 0, below = 0;
  for (const double weight : weights) all += weight;
  std::vector<Range> ranges;
  std::size_t node = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = node;
    const double end = all * static_cast<double>(i + 1) / static_cast<double>(count);
    while (node < weights.size() && (i + 1 == count || below + weights[node] / 2 <= end))
      below += weights[node++];
    ranges.push_back({begin, node});
  }
  return ranges;
}

void include_places(std::uint32_t node, const Numbering& numbering, Share::Places& places) {
  for (int axis = 0; axis < 3; ++axis) {
    const Dof dof = numbering.dof(node, axis);
    places[numbering.is_unknown(dof) ? 0 : 1].include(dof.at());
  }
}

/// The tiles of a tiling that are chosen, by colours as before.
template <class Choose>
Share::Tiles choose_tiles(const Tiling& tiling, const Choose& is_chosen) {
  Share::Tiles tiles;
  for (std::size_t colour = 0; colour + 1 < tiling.colour_begin.size(); ++colour) {
    tiles.colour_begin.push_back(tiles.order.size());
    for (std::size_t i = tiling.colour_begin[colour]; i < tiling.colour_begin[colour + 1]; ++i)
      if (is_chosen(tiling.order[i])) tiles.order.push_back(tiling.order[i]);
  }
  tiles.colour_begin.push_back(tiles.order.size());
  return tiles;
}

void add_group(const FamilyGroup& group, const Numbering& numbering, Share& share) {
  const Tiling& tiling = group.tiling;
  const auto is_own = [&](std::uint32_t node) { return node >= share.nodes.begin && node < share.nodes.end; };
  share.groups.push_back(choose_tiles(tiling, [&](std::uint32_t tile) {
    bool touches = false;
    visit_nodes(tiling, tile, [&](std::uint32_t node) { touches = touches || is_own(node); });
    return touches;
  }));
  // The first node of a tile decides whose energy it is, so each is counted once.
  share.own.push_back(choose_tiles(
      tiling, [&](std::uint32_t tile) { return is_own(tiling.family->node(tile * NETLOFT_LANES, 0)); }));
  for (const std::uint32_t tile : share.groups.back().order)
    visit_nodes(tiling, tile, [&](std::uint32_t node) { include_places(node, numbering, share.needed); });
  for (const std::uint32_t tile : share.own.back().order)
    share.own_tiles.push_back(static_cast<std::uint32_t>(group.first_tile) + tile);
}

}  // namespace

std::vector<Share> divide(std::span<const FamilyGroup> groups, const Numbering& numbering,
                          std::span<const std::size_t> first_slot, std::size_t count) {
  std::vector<Share> shares;
  for (const Range& nodes : cut(weigh_nodes(groups, numbering.dofs() / 3), count)) {
    Share& share = shares.emplace_back();
    share.nodes = nodes;
    share.slots = {first_slot[nodes.begin], first_slot[nodes.end]};
    for (std::size_t node = nodes.begin; node < nodes.end; ++node)
      include_places(static_cast<std::uint32_t>(node), numbering, share.places);
    for (const FamilyGroup& group : groups) add_group(group, numbering, share);
  }
  return shares;
}

}  // namespace netloft
