// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <cstdint>

namespace netloft::conformance {

/// Stands in a slot while an element is tested, so that its checks lean on no plugin. With h = D for twines,
/// 1 for screens:
///   F = ½ ρ h (1 + S) [‖W‖ W + 0.5 (W·t) ‖W‖ t]
/// twice differentiable but at W = 0, takes energy only, uses every input.
netloft_bound_law test_law(std::uint32_t kind);

}  // namespace netloft::conformance
