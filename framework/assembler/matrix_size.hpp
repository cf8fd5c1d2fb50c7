// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace netloft {

/// Largest number of values of a matrix. Its indices have 32 bits; those of its factors have 64 bits.
inline constexpr std::size_t kMostValues = 0x7fffffff;

/// Throws std::length_error with a sentence if this number of node pairs, with nine values each, exceeds
/// kMostValues.
void require_indices(std::size_t blocks);

}  // namespace netloft
