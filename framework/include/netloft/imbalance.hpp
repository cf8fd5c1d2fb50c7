// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft {

/// The least imbalance that matters, over the load, the least stiffness, over the linear one, and the least
/// strain. All have one reason: drag, stiffness and lengths of netting are known to a hundredth at best, and
/// a tenth of that tells no gear from another.
inline constexpr double kMatters = 1e-3;

}  // namespace netloft
