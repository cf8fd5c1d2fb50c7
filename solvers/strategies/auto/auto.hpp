// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/auto_options.hpp"

#include <netloft/strategy.hpp>

namespace netloft::automatic {

/// The default strategy. It runs the attempts that suit the scene, in slices of work, until one converges;
/// then it restarts if there may be several equilibria. README.md explains what happens when attempts fail.
struct Auto {
  using Parameters = Options;
  static void run(const Options& options, Search& search);
  static std::string explain(const Options& options, Search& search);
};

}  // namespace netloft::automatic
