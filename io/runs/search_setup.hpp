// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

namespace netloft::runs {

/// Options of a search by the solver of the scene's analysis.
SearchOptions search_options(PreparedScene& scene, const Limits& limits, const Watch& watch);

StrategyUse strategy_of(PreparedScene& scene);

/// Rejects equilibria in which the half gear has crossed its own plane of symmetry, since the whole gear has
/// none there. Nodes that are held beyond the plane were put there on purpose.
void reject_crossed_halves(const scenes::LoadedScene& loaded, const Assembler& assembler, Solution& s);

}  // namespace netloft::runs
