// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/auto_options.hpp"

#include <netloft/strategy.hpp>

namespace netloft::automatic {

/// Whether restarts are possible in this scene, as far as can be known before an equilibrium has been found.
bool may_restart(const Search& search, const Options& options);

/// Looks for other equilibria, starting from the equilibrium `first`, because parts in compression may fold
/// in several ways. It does so only if all forces have an energy and compression bears a load; the option
/// `everywhere` drops both conditions. The first restart is from the shape without resistance to compression,
/// all others are from perturbations of the best shape so far. Each restart costs at most a slice of work.
/// The host chooses among the equilibria that are found.
void restart(Search& search, const Options& options, const Stage& first);

}  // namespace netloft::automatic
