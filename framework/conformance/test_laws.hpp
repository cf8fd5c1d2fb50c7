// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/laws.h>

#include <atomic>
#include <cstdint>

namespace netloft::conformance {

/// Lanes for which a law was called, and those of them whose extent is not a positive number.
struct LaneCounts {
  std::atomic<std::uint64_t> all{0}, wrong{0};
};

/// A law in the slots of an element under test, so that its checks need no plugin. With h = D for twines, 1
/// for screens:
///   F = ½ ρ h (1 + S) [‖W‖ W + 0.5 (W·t) ‖W‖ t]
/// It is twice differentiable except at W = 0, passive, and uses every input. `lanes` counts lanes unless it
/// is null, and must outlive the law.
netloft_bound_law test_law(std::uint32_t kind, LaneCounts* lanes = nullptr);

}  // namespace netloft::conformance
