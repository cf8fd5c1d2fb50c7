// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/settle.hpp"

#include "framework/motion/settling.hpp"
#include "io/runs/step_methods.hpp"

#include <algorithm>
#include <limits>

namespace netloft::runs {

namespace {

constexpr const char* kStepSolver = "chord";
constexpr Limits kStepLimits{1e-8, 25, std::numeric_limits<double>::infinity(), nullptr};
constexpr double kStepsFiner = 0.1;  // tolerance of a time step, relative to the tolerance of the equilibrium

}  // namespace

Solution settle(PreparedScene& scene, const Watch& watch, const std::vector<double>& from) {
  const scenes::Analysis& analysis = scene.loaded().analysis;
  Assembler& assembler = scene.assembler();
  const ChosenStepMethods chosen(analysis.dynamics, kStepSolver, {}, scene.registry());
  const AssembledScene assembled{scene.loaded().scene, assembler, scene.factorisations()};
  Settling settling{assembled, chosen.methods(), kStepLimits, analysis.dynamics.march};
  settling.limits.interrupt = watch.interrupt;
  settling.limits.tolerance = std::min(kStepLimits.tolerance, kStepsFiner * analysis.limits.tolerance);
  settling.limits.seconds = analysis.limits.seconds;
  const WorkModel model = work_of_steps(assembler, scene.factorisations());
  settling.limits.model = &model;
  settling.limits.work = analysis.work;
  Limits limits = analysis.limits;
  limits.interrupt = watch.interrupt;
  const SolverType as_solver = settling.as_solver();
  Solution s =
      solve_static(assembled, {&as_solver, &settling}, limits, {from}, {watch.on_iteration, watch.kept});
  if (s.status == SolveStatus::converged) assembler.remember(s.x);
  return s;
}

}  // namespace netloft::runs
