// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/tiling.hpp"

#include <span>

namespace netloft {

/// Whether both families have the same nodes, element by element, as riders have those of what they ride on:
/// what has been found of the nodes of one then holds for the other.
bool have_same_nodes(const ElementFamily& a, const ElementFamily& b);

/// The tiling of a family with the same nodes; null if there is none.
const Tiling* find_alike(std::span<const Tiling> tilings, const ElementFamily& family);

/// A tiling for a family with the same nodes, with spare slots of its own.
Tiling make_tiling_like(const Tiling& other, const ElementFamily& family, std::size_t first_spare);

}  // namespace netloft
