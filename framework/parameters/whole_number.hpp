// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>

namespace netloft {

/// Up to this number, 2^53, every whole number can be stored as a double.
inline constexpr double kMostWhole = 0x1p53;

/// Returns the value as a whole number, or nullopt if it is not whole or exceeds kMostWhole.
inline std::optional<std::int64_t> whole_number(double value) {
  if (!(std::abs(value) <= kMostWhole) || value != std::trunc(value)) return {};
  return static_cast<std::int64_t>(value);
}

}  // namespace netloft
