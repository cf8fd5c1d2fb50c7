// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft {

/// Energies that differ by less than this fraction of them are equal: rounding of a sum of many terms.
inline constexpr double kEnergyRoundOff = 1e-13;

}  // namespace netloft
