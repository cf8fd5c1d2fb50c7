// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>

#include "framework/problem/factorisation.hpp"

namespace netloft {

/// Column of the first value that is infinite or not a number, -1 if all are finite. BLAS lets such values
/// through without a word.
std::int32_t find_column_not_finite(const SparsePattern& pattern, std::span<const double> values);

}  // namespace netloft
