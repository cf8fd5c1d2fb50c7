// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft {

/// Relative difference below which two energies count as equal, because of rounding in a sum of many terms.
inline constexpr double kEnergyRoundOff = 1e-13;

}  // namespace netloft
