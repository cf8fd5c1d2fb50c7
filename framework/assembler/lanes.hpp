// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <cstddef>

namespace netloft {

/// Number of elements of a tile. Arrays of a tile have rows of this many numbers, one per element.
inline constexpr std::size_t kTileLanes = NETLOFT_LANES;

/// Number of entries of the lower triangle of a `dofs` x `dofs` matrix. In packed storage, entry (r, c), c <=
/// r, has index packed(r) + c.
inline std::size_t packed(std::size_t dofs) { return dofs * (dofs + 1) / 2; }

}  // namespace netloft
