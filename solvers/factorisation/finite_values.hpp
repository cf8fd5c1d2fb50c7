// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>

#include "framework/balance/factorisation.hpp"

namespace netloft {

/// Returns the column of the first value that is infinite or NaN, or -1 if all are finite. The check is
/// needed because BLAS does not report such values.
std::int32_t find_column_not_finite(const SparsePattern& pattern, std::span<const double> values);

}  // namespace netloft
