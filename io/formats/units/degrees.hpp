// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <numbers>

namespace netloft::formats {

inline constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

constexpr double in_radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace netloft::formats
