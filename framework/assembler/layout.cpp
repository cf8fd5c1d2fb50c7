// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/layout.hpp"

#include "framework/assembler/riders.hpp"

#include <algorithm>

namespace netloft {

namespace {

std::vector<std::vector<std::uint32_t>> nodes_of_bodies(const Scene& scene) {
  std::vector<std::vector<std::uint32_t>> all;
  for (const RigidBody& body : scene.bodies) {
    auto& nodes = all.emplace_back();
    nodes = {body.origin, body.rotation_node};
    for (const auto& point : body.points) nodes.push_back(point.node);
  }
  return all;
}

bool have_same_elements(const std::unique_ptr<ElementFamily>& a, const std::unique_ptr<ElementFamily>& b) {
  return &a->type() == &b->type() && have_same_nodes(*a, *b);
}

}  // namespace

std::shared_ptr<const Layout> make_layout(Families families, const Scene& nodes, bool symmetric) {
  auto layout = std::make_shared<Layout>();
  layout->held = nodes.held;
  layout->carried = nodes.carried;
  layout->bodies = nodes_of_bodies(nodes);
  layout->blocks = make_blocks(families, nodes, symmetric);
  layout->pattern = make_pattern(layout->blocks, Numbering(nodes), symmetric);
  return layout;
}

bool is_layout_of(const Layout& layout, Families others, Families families, const Scene& nodes,
                  bool symmetric) {
  return layout.pattern.symmetric == symmetric && layout.held == nodes.held &&
         layout.carried == nodes.carried && layout.bodies == nodes_of_bodies(nodes) &&
         std::ranges::equal(others, families, have_same_elements);
}

}  // namespace netloft
