// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace netloft {

/// The smallest ratio that matters: of an unbalanced force to the load, of a stiffness to the linear
/// stiffness, or of a change of length to the length. Drag, stiffness and lengths of netting are known to 1 %
/// at best, so that a tenth of 1 % makes no difference to a gear.
inline constexpr double kMatters = 1e-3;

}  // namespace netloft
