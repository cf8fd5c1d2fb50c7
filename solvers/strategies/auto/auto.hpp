// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/options.hpp"

#include <netloft/strategy.hpp>

namespace netloft::automatic {

/// The default: tries what suits the scene, in slices of work, until an equilibrium is found that is stable;
/// keeps the digits of positions where rounding is all that is left; looks for other shapes where there may
/// be some.
struct Auto {
  using Parameters = Options;
  static void run(const Options& options, Study& study);
  static std::string explain(const Options& options, Study& study);
};

}  // namespace netloft::automatic
