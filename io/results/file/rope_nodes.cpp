// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/rope_nodes.hpp"

namespace netloft::results {

std::vector<std::uint32_t> nodes_of_rope(const StoredShape& stored, const std::string& name) {
  std::vector<std::uint32_t> nodes;
  const auto part = find_part(stored, name);
  for (std::size_t i = 0; part && i < stored.mesh.bars.size(); ++i) {
    if (stored.mesh.cell_part[stored.mesh.bar_cells[i]] != *part) continue;
    if (nodes.empty()) nodes.push_back(stored.mesh.bars[i][0]);
    nodes.push_back(stored.mesh.bars[i][1]);
  }
  return nodes;
}

}  // namespace netloft::results
