// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

namespace netloft::results {

/// Where a field or a table has no number.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace netloft::results
