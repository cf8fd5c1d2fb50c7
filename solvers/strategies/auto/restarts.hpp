// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/auto_options.hpp"

#include <netloft/strategy.hpp>

namespace netloft::automatic {

/// Whether restarts are possible in this scene, as far as can be known before an equilibrium has been found.
bool may_restart(const Search& search, const Options& options);

/// Looks for equilibria other than `first`. If members bear all loads by tension, the energy is convex, and
/// no other equilibrium has less energy. Other shapes are therefore looked for only if all forces have a
/// potential, and if compression or bending bears more than kOnlyAStart of the load:
///   compression: parts in compression fold in several ways. The first restart is from the shape without
///     resistance to compression, all others are from perturbations of the best shape so far.
///   bending (of meshes held open, of bent ropes or netting), if the shape would not be stable without it:
///     strategies with tensions as unknowns may crumple the netting before they converge, and bending may
///     keep it crumpled. The first restart is from `start`, the start of the search, all others are from
///     perturbations of `start`: each is solved from soft to stiff, with bending in proportion to tension,
///     and then by the solver alone.
/// The option `everywhere` drops the conditions for the restarts because of compression. Each restart costs
/// at most a slice of work more than the first equilibrium has cost (`spent`). The host chooses among the
/// equilibria that are found.
void restart(Search& search, const Options& options, const Displacements& start, const Stage& first,
             double spent);

}  // namespace netloft::automatic
