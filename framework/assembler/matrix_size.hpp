// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

/// Values that a matrix may have: its indices have 32 bits, those of its factors 64.
inline constexpr std::size_t kMostValues = 0x7fffffff;

/// Throws std::length_error with a sentence where so many pairs of nodes have more values than that, nine
/// each.
void require_indices(std::size_t blocks);

}  // namespace netloft
