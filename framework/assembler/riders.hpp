// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/tiling.hpp"

#include <span>

namespace netloft {

/// Whether both families have the same nodes, element by element, as riders have those of what they ride on:
/// what has been found of the nodes of one then holds for the other.
bool have_same_nodes(const ElementFamily& a, const ElementFamily& b);

/// A family and those that ride on it: one tiling serves them all, and a tile is gathered once, and scattered
/// when all of them have added to it.
struct FamilyGroup {
  Tiling tiling;
  std::vector<std::size_t> families;  // the one that is ridden on first
  std::size_t first_tile = 0;         // among those of all groups
};

/// Groups families with the same nodes, in the order of the first of each; tilings are not made yet.
std::vector<FamilyGroup> find_family_groups(std::span<const std::unique_ptr<ElementFamily>> families);

}  // namespace netloft
