// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

namespace netloft::results {

/// Stands for a missing number in a field or a table.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace netloft::results
