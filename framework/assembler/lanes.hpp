// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <cstddef>

namespace netloft {

/// Elements of a tile. Arrays of a tile have rows of this many numbers, one per element.
inline constexpr std::size_t kTileLanes = NETLOFT_LANES;

/// Rows of a packed lower triangle with `dofs` rows of a matrix; entry (r, c), c <= r, is row packed(r) + c.
inline std::size_t packed(std::size_t dofs) { return dofs * (dofs + 1) / 2; }

}  // namespace netloft
