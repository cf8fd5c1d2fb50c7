// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

namespace netloft::results {

/// Marks the absence of a number in a field or a table.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace netloft::results
