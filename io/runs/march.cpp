// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/march.hpp"

#include "io/runs/search_setup.hpp"
#include "io/runs/step_methods.hpp"
#include "io/scenes/reading/keys.hpp"

#include <cassert>
#include <cmath>
#include <optional>

namespace netloft::runs {

namespace {

/// The equilibrium that a motion starts from, with the forces, tangent, tolerance and solver of a static
/// analysis: a motion may leave out parts of the tangent and still swing about this equilibrium. Both number
/// their unknowns alike.
Solution find_start(PreparedScene& scene, const Watch& watch) {
  const scenes::LoadedScene& loaded = scene.loaded();
  const ScenePlan plan = make_scene_plan(loaded.scene, scene.registry());
  Assembler assembler(loaded.scene, plan, scene.source().threads);
  assert(assembler.pattern().size == scene.assembler().pattern().size);
  VariantSource source = scene.variants();
  source.assembler = &assembler;
  source.tangent = TangentChoice::exact;
  Limits limits;
  limits.seconds = loaded.analysis.limits.seconds;
  limits.judging.accept_oscillation = loaded.analysis.limits.judging.accept_oscillation;
  SearchOptions options =
      search_options(scene, limits, {.interrupt = watch.interrupt, .on_iteration = watch.on_iteration});
  options.solver = {&scene.registry().solver(scenes::kSolver), {}};
  Solution found = netloft::find_equilibrium(source, options, strategy_of(scene));
  reject_crossed_halves(loaded, assembler, found);
  if (found.status == SolveStatus::converged || found.status == SolveStatus::unstable)
    remember(scene, found.u);
  return found;
}

MarchResult without_start(const Solution& s) {
  MarchResult none;
  none.reason = "there is no equilibrium to start from: " + s.reason;
  none.u = s.u;
  return none;
}

MarchState at_rest(Assembler& assembler, const Solution& s) {
  MarchState state = state_at_rest(assembler, s.u);
  state.winches = Winches::state_at_rest(s.factors);
  return state;
}

}  // namespace

MarchResult march(PreparedScene& scene, const MarchWatch& outputs, const Watch& watch, const MarchState* from,
                  double work) {
  const scenes::Analysis& a = scene.loaded().analysis;
  const ChosenStepMethods chosen(a.dynamics, a.solver, a.solver_parameters, scene.registry());
  Limits limits = a.limits;
  limits.interrupt = watch.interrupt;
  std::optional<WorkModel> model;
  if (std::isfinite(work)) {
    limits.model = &model.emplace(work_of_steps(scene.assembler(), scene.factorisations()));
    limits.work = work;
  }
  assert(from || a.dynamics.start_file.empty());  // the caller reads the result
  std::optional<MarchState> start;
  std::string remark;
  if (!from && a.dynamics.from_equilibrium) {
    const Solution s = find_start(scene, watch);
    if (!is_stationary(s)) return without_start(s);
    if (s.status == SolveStatus::unstable)
      remark = "; it began at an equilibrium that is not stable: " + s.reason;
    from = &start.emplace(at_rest(scene.assembler(), s));
  }
  MarchResult result = netloft::march({scene.loaded().scene, scene.assembler(), scene.factorisations()},
                                      chosen.methods(), limits, a.dynamics.march, outputs, from);
  result.reason += remark;
  return result;
}

void remember(PreparedScene& scene, std::span<const double> u) {
  std::vector<double> x(scene.assembler().start());
  scene.assembler().place(u, x);
  scene.assembler().remember(x);
}

}  // namespace netloft::runs
