// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/laws.h>

#include <atomic>
#include <cstdint>

namespace netloft::conformance {

/// Number of lanes for which a law was called, and number of those whose extent (metres of twine, square
/// metres of netting) is not a positive number.
struct LaneCounts {
  std::atomic<std::uint64_t> all{0}, wrong{0};
};

/// A law for the checks of elements, so that the checks need no plugin with laws. With the relative velocity
/// W of the water, its density ρ, the direction t, the solidity S, and h = D (the diameter) for twines, 1 for
/// screens:
///   F = ½ ρ h (1 + S) [‖W‖ W + 0.5 (W·t) ‖W‖ t]
/// F is passive, twice differentiable except at W = 0, and depends on every input. If `lanes` is not nullptr,
/// it counts lanes; it must outlive the law.
netloft_bound_law test_law(std::uint32_t kind, LaneCounts* lanes = nullptr);

}  // namespace netloft::conformance
