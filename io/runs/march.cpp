// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/march.hpp"

#include "io/runs/equilibrium.hpp"
#include "io/runs/step_methods.hpp"

#include <cassert>
#include <cmath>
#include <optional>

namespace netloft::runs {

namespace {

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
  assert(from || a.dynamics.start_file.empty());  // the caller must read a start from a file
  std::optional<MarchState> start;
  if (!from && a.dynamics.from_equilibrium) {
    const Solution s = find_start_of_motion(scene, watch);
    if (!is_stationary(s)) return without_start(s);
    remember(scene, s.u);
    from = &start.emplace(at_rest(scene.assembler(), s));
    if (s.status == SolveStatus::unstable)
      start->remark = "; it began at an equilibrium that is not stable: " + s.reason;
  }
  return netloft::march({scene.loaded().scene, scene.assembler(), scene.factorisations()}, chosen.methods(),
                        limits, a.dynamics.march, outputs, from);
}

void remember(PreparedScene& scene, std::span<const double> u) {
  std::vector<double> x(scene.assembler().start());
  scene.assembler().place(u, x);
  scene.assembler().remember(x);
}

}  // namespace netloft::runs
