// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft::formats {

// Line plots and bar charts share these sizes [px] and colours.
inline constexpr double kWidth = 340, kAxisRoom = 38, kLegendLine = 14, kText = 10;
inline constexpr double kLetter = 0.6;  // width of a letter relative to its height, overestimated
inline constexpr const char *kInk = "#222222", *kGrid = "#dddddd";

}  // namespace netloft::formats
