// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>

namespace netloft {

/// Up to here, 2^53, a double holds every whole number.
inline constexpr double kMostWhole = 0x1p53;

/// The whole number that a double is; nothing if it is none, or beyond kMostWhole.
inline std::optional<std::int64_t> whole_number(double value) {
  if (!(std::abs(value) <= kMostWhole) || value != std::trunc(value)) return {};
  return static_cast<std::int64_t>(value);
}

}  // namespace netloft
