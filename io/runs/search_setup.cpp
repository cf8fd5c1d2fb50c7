// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/search_setup.hpp"

#include "io/scenes/reading/halves.hpp"

namespace netloft::runs {

SearchOptions search_options(PreparedScene& scene, const Limits& limits, const Watch& watch) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  SearchOptions options;
  options.solver = {&scene.registry().solver(analysis.solver), analysis.solver_parameters};
  options.limits = limits;
  options.limits.interrupt = watch.interrupt;
  options.given = analysis.given;
  options.kept = watch.kept;
  options.work = analysis.work;
  options.on_iteration = watch.on_iteration;
  options.on_stage = watch.on_stage;
  return options;
}

StrategyUse strategy_of(PreparedScene& scene) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  return {&scene.registry().strategy(analysis.strategy), analysis.strategy_parameters};
}

void reject_crossed_halves(const scenes::LoadedScene& loaded, const Assembler& assembler, Solution& s) {
  if (!is_stationary(s) || !loaded.gear || loaded.gear->times != 2) return;
  for (const scenes::Crossing& crossing : scenes::find_crossings(loaded, assembler.node_positions(s.x)))
    if (!crossing.is_held) {
      s.status = SolveStatus::not_converged;
      s.at_fault = loaded.scene.parts[crossing.part].name;
      s.reason = crossing.sentence + ". No whole gear lies so; start it elsewhere, or solve it as a whole";
    }
}

}  // namespace netloft::runs
