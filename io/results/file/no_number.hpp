// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

namespace netloft::results {

/// The number (NaN) that stands in a field or a table where there is no number.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace netloft::results
