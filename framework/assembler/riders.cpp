// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/riders.hpp"

#include <algorithm>

namespace netloft {

bool have_same_nodes(const ElementFamily& a, const ElementFamily& b) {
  const int nodes = a.all_nodes_per_element();
  if (a.size() != b.size() || nodes != b.all_nodes_per_element()) return false;
  for (std::size_t e = 0; e < a.size(); ++e)
    for (int n = 0; n < nodes; ++n)
      if (a.node(e, n) != b.node(e, n)) return false;
  return true;
}

const Tiling* find_alike(std::span<const Tiling> tilings, const ElementFamily& family) {
  const auto at = std::find_if(tilings.begin(), tilings.end(),
                               [&](const Tiling& tiling) { return have_same_nodes(*tiling.family, family); });
  return at == tilings.end() ? nullptr : &*at;
}

Tiling make_tiling_like(const Tiling& other, const ElementFamily& family, std::size_t first_spare) {
  Tiling tiling = other;
  tiling.family = &family, tiling.first_spare = first_spare;
  const auto first = static_cast<std::int32_t>(other.first_spare),
             shift = static_cast<std::int32_t>(first_spare) - first;
  for (std::int32_t& block : tiling.block_map)
    if (block >= first) block += shift;
  return tiling;
}

}  // namespace netloft
