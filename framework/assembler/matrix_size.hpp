// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

/// Largest number of values of a matrix, whose indices have 32 bits. (The indices of factors have 64 bits.)
inline constexpr std::size_t kMostValues = 0x7fffffff;

/// Throws std::length_error with a sentence if a matrix with `blocks` node pairs, nine values each, has more
/// than kMostValues values.
void require_indices(std::size_t blocks);

}  // namespace netloft
