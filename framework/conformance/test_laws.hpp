// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <atomic>
#include <cstdint>

namespace netloft::conformance {

/// Lanes that a law was asked for, and those of them with an extent that is no positive number.
struct AskedLanes {
  std::atomic<std::uint64_t> told{0}, wrong{0};
};

/// Stands in a slot while an element is tested, so that its checks lean on no plugin. With h = D for twines,
/// 1 for screens:
///   F = ½ ρ h (1 + S) [‖W‖ W + 0.5 (W·t) ‖W‖ t]
/// twice differentiable but at W = 0, takes energy only, uses every input. `asked` counts lanes, if it is not
/// null, and must outlive the law.
netloft_bound_law test_law(std::uint32_t kind, AskedLanes* asked = nullptr);

}  // namespace netloft::conformance
