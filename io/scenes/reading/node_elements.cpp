// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/node_elements.hpp"

#include <algorithm>

namespace netloft::scenes {

NodeElements::NodeElements(const Scene& scene, const std::vector<const ElementType*>& types)
    : begins_(scene.node_count() + 1, 0) {
  const std::size_t parts = std::min(types.size(), scene.parts.size());
  for (std::size_t p = 0; p < parts; ++p)
    if (types[p])
      for (const auto node : scene.parts[p].nodes) ++begins_[node + 1];
  for (std::size_t node = 1; node < begins_.size(); ++node) begins_[node] += begins_[node - 1];
  all_.resize(begins_.back());
  std::vector<std::size_t> next = begins_;
  for (std::uint32_t p = 0; p < parts; ++p) {
    if (!types[p]) continue;
    const auto& nodes = scene.parts[p].nodes;
    const auto corners = static_cast<std::uint32_t>(types[p]->nodes());
    for (std::uint32_t i = 0; i < nodes.size(); ++i) all_[next[nodes[i]]++] = {p, i / corners};
  }
}

std::span<const NodeElements::At> NodeElements::at(std::uint32_t node) const {
  return std::span(all_).subspan(begins_[node], begins_[node + 1] - begins_[node]);
}

std::span<const NodeElements::At> NodeElements::at(std::uint32_t node, std::size_t part) const {
  const auto all = at(node);
  const auto [first, last] = std::equal_range(all.begin(), all.end(), At{static_cast<std::uint32_t>(part), 0},
                                              [](const At& a, const At& b) { return a.part < b.part; });
  return {first, last};
}

}  // namespace netloft::scenes
