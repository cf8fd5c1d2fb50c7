// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/tiling.hpp"

#include <algorithm>

namespace netloft {

namespace {

constexpr std::size_t kLanes = NETLOFT_LANES;

/// Greedy colours: a tile takes the lowest colour that none of its nodes has seen yet.
std::vector<int> colour_tiles(const Family& family, std::size_t tiles, std::size_t nodes) {
  std::vector<std::uint64_t> taken(nodes, 0);  // colours used at a node; tiles beyond 64 colours go alone
  std::vector<int> colours(tiles);
  int next_alone = 64;
  for (std::size_t t = 0; t < tiles; ++t) {
    std::uint64_t seen = 0;
    const std::size_t end = std::min(family.size(), (t + 1) * kLanes);
    const auto for_nodes = [&](auto&& visit) {
      for (std::size_t e = t * kLanes; e < end; ++e)
        for (int n = 0; n < family.nodes_per_element(); ++n) visit(family.node(e, n));
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

std::size_t count_nodes(const Family& family) {
  std::uint32_t last = 0;
  for (std::size_t e = 0; e < family.size(); ++e)
    for (int n = 0; n < family.nodes_per_element(); ++n) last = std::max(last, family.node(e, n));
  return std::size_t{last} + 1;
}

void map_vectors(const Numbering& numbering, Tiling& tiling) {
  const Family& family = *tiling.family;
  const auto dofs = static_cast<std::size_t>(family.type().dofs());
  tiling.vector_map.assign(tiling.tiles * dofs * kLanes, 0);
  for (std::size_t e = 0; e < family.size(); ++e)
    for (std::size_t d = 0; d < dofs; ++d)
      tiling.vector_map[(e / kLanes * dofs + d) * kLanes + e % kLanes] =
          numbering.index(family.node(e, static_cast<int>(d / 3)), static_cast<int>(d % 3));
}

void map_element(const SparsePattern& pattern, const Tiling& tiling, std::size_t e,
                 std::vector<std::int32_t>& map) {
  const auto dofs = static_cast<std::size_t>(tiling.family->type().dofs());
  const std::int32_t* place = &tiling.vector_map[e / kLanes * dofs * kLanes + e % kLanes];
  const auto spare = static_cast<std::int32_t>(tiling.first_spare + e / kLanes);
  std::size_t entry = 0;
  for (std::size_t r = 0; r < dofs; ++r)
    for (std::size_t c = 0; c < (pattern.symmetric ? r + 1 : dofs); ++c, ++entry) {
      std::int32_t row = place[r * kLanes], column = place[c * kLanes];
      if (pattern.symmetric && row < column) std::swap(row, column);
      const bool held = row >= pattern.size || column >= pattern.size;
      map[(e / kLanes * tiling.entries_per_element + entry) * kLanes + e % kLanes] =
          held ? spare : static_cast<std::int32_t>(find_entry(pattern, row, column));
    }
}

}  // namespace

std::size_t Tiling::lanes(std::size_t tile) const { return std::min(kLanes, family->size() - tile * kLanes); }

Tiling make_tiling(const Family& family, const Numbering& numbering, const SparsePattern& pattern,
                   std::size_t first_spare) {
  Tiling tiling;
  tiling.family = &family;
  tiling.tiles = (family.size() + kLanes - 1) / kLanes;
  tiling.first_spare = first_spare;
  const auto dofs = static_cast<std::size_t>(family.type().dofs());
  tiling.entries_per_element = pattern.symmetric ? dofs * (dofs + 1) / 2 : dofs * dofs;
  order_by_colour(colour_tiles(family, tiling.tiles, count_nodes(family)), tiling);
  map_vectors(numbering, tiling);
  tiling.matrix_map.assign(tiling.tiles * tiling.entries_per_element * kLanes, 0);
  for (std::size_t e = 0; e < family.size(); ++e) map_element(pattern, tiling, e, tiling.matrix_map);
  return tiling;
}

}  // namespace netloft
