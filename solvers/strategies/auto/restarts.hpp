// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/auto_options.hpp"

#include <netloft/strategy.hpp>

namespace netloft::automatic {

/// Whether restarts are possible in this scene, before it is known whether compression bears a load.
bool may_restart(const Search& search, const Options& options);

/// Looks for other equilibria, starting from the equilibrium `first`, because parts in compression may fold
/// in several ways. This is done only if all forces have an energy and compression bears a load; `everywhere`
/// drops both conditions. The first restart is from the shape without resistance to compression, the next
/// ones are from perturbations of the best shape so far. Each restart costs at most a slice of work. The host
/// chooses among the equilibria that are found.
void restart(Search& search, const Options& options, const Stage& first);

}  // namespace netloft::automatic
