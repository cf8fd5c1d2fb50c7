// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft {

/// The smallest imbalance (as a fraction of the load), stiffness (as a fraction of the linear stiffness) and
/// strain that matter. Drag, stiffness and lengths of netting are known to 1 % at best; a difference of a
/// tenth of that, 1e-3, does not change a gear.
inline constexpr double kMatters = 1e-3;

}  // namespace netloft
