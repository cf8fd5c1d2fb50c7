// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft {

/// The least imbalance that matters, over the load, and the least stiffness, over the linear one. Both have
/// one reason: drag and stiffness of netting are known to a hundredth at best, and a tenth of that tells no
/// gear from another.
inline constexpr double kMatters = 1e-3;

}  // namespace netloft
