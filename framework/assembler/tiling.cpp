// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/tiling.hpp"

#include "framework/assembler/lanes.hpp"

#include <algorithm>
#include <cassert>

namespace netloft {

namespace {

/// Greedy colouring: a tile gets the lowest colour that no other tile at its nodes has.
std::vector<int> colour_tiles(const ElementFamily& family, std::size_t tiles, std::size_t nodes) {
  // The colours used at a node, one bit each. A tile for which none of 64 colours is left runs alone.
  std::vector<std::uint64_t> taken(nodes, 0);
  std::vector<int> colours(tiles);
  int next_alone = 64;
  for (std::size_t t = 0; t < tiles; ++t) {
    std::uint64_t seen = 0;
    const std::size_t end = std::min(family.size(), (t + 1) * kTileLanes);
    const auto for_nodes = [&](auto&& visit) {
      for (std::size_t e = t * kTileLanes; e < end; ++e)
        for (int n = 0; n < family.all_nodes_per_element(); ++n) visit(family.node(e, n));
    };
    for_nodes([&](std::uint32_t node) { seen |= taken[node]; });
    if (seen == ~std::uint64_t{0}) {
      colours[t] = next_alone++;
      continue;
    }
    int colour = 0;
    while (seen >> colour & 1) ++colour;
    colours[t] = colour;
    for_nodes([&](std::uint32_t node) { taken[node] |= std::uint64_t{1} << colour; });
  }
  return colours;
}

void order_by_colour(const std::vector<int>& colours, Tiling& tiling) {
  tiling.order.resize(colours.size());
  for (std::uint32_t t = 0; t < colours.size(); ++t) tiling.order[t] = t;
  std::stable_sort(tiling.order.begin(), tiling.order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return colours[a] < colours[b]; });
  for (std::size_t i = 0; i < colours.size(); ++i)
    if (i == 0 || colours[tiling.order[i]] != colours[tiling.order[i - 1]]) tiling.colour_begin.push_back(i);
  tiling.colour_begin.push_back(colours.size());
}

void map_vectors(const Numbering& numbering, Tiling& tiling) {
  const ElementFamily& family = *tiling.family;
  const auto dofs = static_cast<std::size_t>(family.type().dofs());
  tiling.vector_map.assign(tiling.tiles * dofs * kTileLanes, 0);
  for (std::size_t e = 0; e < family.size(); ++e)
    for (std::size_t d = 0; d < dofs; ++d)
      tiling.vector_map[(e / kTileLanes * dofs + d) * kTileLanes + e % kTileLanes] =
          numbering.dof(family.node(e, static_cast<int>(d / 3)), static_cast<int>(d % 3)).place;
}

/// Returns the index in the array of matrix values to which block (P, Q) of two corners of an element is
/// added, or ~index if the transpose is added instead. If a node is held, returns the unused block `spare`.
std::int32_t find_block(const ElementFamily& family, const Scene& scene, const NodeBlocks& blocks,
                        bool symmetric, std::size_t e, int P, int Q, std::size_t spare) {
  const std::uint32_t row = family.node(e, P), column = family.node(e, Q);
  if (scene.stands_still(row) || scene.stands_still(column)) return static_cast<std::int32_t>(spare);
  if (symmetric && row < column) return ~static_cast<std::int32_t>(blocks.base(column, row));
  return static_cast<std::int32_t>(blocks.base(row, column));
}

void map_blocks(const Scene& scene, const NodeBlocks& blocks, bool symmetric, Tiling& tiling) {
  const ElementFamily& family = *tiling.family;
  const int corners = family.all_nodes_per_element();
  tiling.blocks_per_element =
      static_cast<std::size_t>(symmetric ? corners * (corners + 1) / 2 : corners * corners);
  tiling.block_map.assign(tiling.tiles * tiling.blocks_per_element * kTileLanes, 0);
  for (std::size_t e = 0; e < family.size(); ++e) {
    std::int32_t* map =
        &tiling.block_map[e / kTileLanes * tiling.blocks_per_element * kTileLanes + e % kTileLanes];
    const std::size_t spare = tiling.first_spare + 9 * (e / kTileLanes);
    for (int P = 0; P < corners; ++P)
      for (int Q = 0; Q < (symmetric ? P + 1 : corners); ++Q, map += kTileLanes)
        *map = find_block(family, scene, blocks, symmetric, e, P, Q, spare);
  }
}

void find_twins(const Scene& scene, Tiling& tiling) {
  const ElementFamily& family = *tiling.family;
  tiling.twins.resize(tiling.tiles);
  for (std::size_t e = 0; e < family.size(); ++e)
    for (int P = 0; P < family.all_nodes_per_element(); ++P)
      for (int Q = 0; Q < P; ++Q)
        if (family.node(e, P) == family.node(e, Q) && !scene.stands_still(family.node(e, P)))
          tiling.twins[e / kTileLanes].push_back({static_cast<std::uint32_t>(e % kTileLanes), P, Q});
}

}  // namespace

std::size_t Tiling::lanes(std::size_t tile) const {
  assert(tile < tiles);
  return std::min(kTileLanes, family->size() - tile * kTileLanes);
}

std::vector<std::uint32_t> find_carried_tiles(const Tiling& tiling, const std::vector<bool>& carried) {
  std::vector<std::uint32_t> tiles;
  const ElementFamily& family = *tiling.family;
  for (std::size_t e = 0; e < family.size(); ++e)
    for (int n = 0; n < family.nodes_per_element(); ++n)
      if (const auto tile = static_cast<std::uint32_t>(e / kTileLanes);
          carried[family.node(e, n)] && (tiles.empty() || tiles.back() != tile))
        tiles.push_back(tile);
  return tiles;
}

Tiling make_tiling(const ElementFamily& family, const Scene& scene, const Numbering& numbering,
                   const NodeBlocks& blocks, bool symmetric, std::size_t first_spare) {
  Tiling tiling;
  tiling.family = &family;
  tiling.tiles = (family.size() + kTileLanes - 1) / kTileLanes;
  tiling.first_spare = first_spare;
  order_by_colour(colour_tiles(family, tiling.tiles, scene.node_count()), tiling);
  map_vectors(numbering, tiling);
  map_blocks(scene, blocks, symmetric, tiling);
  if (symmetric) find_twins(scene, tiling);
  return tiling;
}

}  // namespace netloft
