// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/pattern.hpp"

#include <memory>
#include <span>
#include <vector>

namespace netloft {

/// The arrangement of the matrix values of an assembler. It depends on connections only: the nodes of all
/// elements, the held coordinates, and the nodes of bodies. Assemblers with equal connections share one
/// layout.
struct Layout {
  std::vector<std::uint8_t> held;
  std::vector<bool> carried;
  std::vector<std::vector<std::uint32_t>> bodies;  // origin, rotation node and points of each body
  NodeBlocks blocks;
  SparsePattern pattern;
};

using Families = std::span<const std::unique_ptr<ElementFamily>>;

/// `nodes`: the nodes of the scene, of rotations and of shared unknowns.
std::shared_ptr<const Layout> make_layout(Families families, const Scene& nodes, bool symmetric);

/// Whether `layout`, which was made for the families `others`, also fits `families` and their nodes.
bool is_layout_of(const Layout& layout, Families others, Families families, const Scene& nodes,
                  bool symmetric);

}  // namespace netloft
