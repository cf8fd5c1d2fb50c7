// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/auto_options.hpp"

#include <netloft/strategy.hpp>

namespace netloft::automatic {

/// What is under compression may fold in many ways. Where something bears it at an equilibrium `first` whose
/// forces have an energy, or everywhere if the user says so, others are looked for: from where the gear would
/// be if nothing resisted compression, then from perturbations of the best shape so far. Each is answered;
/// the host chooses among them. Each may cost a slice.
///
/// What of this is known before anything is solved: whether it may come to it.
bool may_restart(const Search& search, const Options& options);
void restart(Search& search, const Options& options, const Stage& first);

}  // namespace netloft::automatic
