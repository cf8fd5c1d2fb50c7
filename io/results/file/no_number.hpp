// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>

namespace netloft::results {

/// The value (NaN) in a field or a table that means "no number".
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace netloft::results
