// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft {

/// Standard gravity, by definition (3rd General Conference on Weights and Measures, 1901) [m/s²].
inline constexpr double kStandardGravity = 9.80665;

}  // namespace netloft
