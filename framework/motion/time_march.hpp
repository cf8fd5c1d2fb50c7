// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/assembled_scene.hpp"
#include "framework/motion/achieved_accuracy.hpp"
#include "framework/motion/energy_budget.hpp"
#include "framework/motion/energy_judge.hpp"
#include "framework/motion/march_ending.hpp"
#include "framework/motion/march_settings.hpp"
#include "framework/motion/march_state.hpp"
#include "framework/motion/step_scheme.hpp"
#include "framework/motion/transient_problem.hpp"
#include "framework/motion/winches.hpp"

#include <limits>

namespace netloft {

/// The methods of a march (an integration in time).
struct StepMethods {
  IntegratorChoice integrator;
  SolverChoice solver;  // solver of implicit steps
};

/// Forces at the end of a step. Forces are not evaluated between the ends of a step, because stiff twines
/// would turn the smallest error of interpolated positions into a large force. If a scheme uses mean forces,
/// the reactions are means over the step, too. Means agree with the change of momentum in the step, whereas
/// forces at its end oscillate from step to step with modes that are too fast for the scheme.
struct ForceMoment {
  double t;  // [s]
  // Over all dofs: positions [m]; residual, with reactions of held dofs [N].
  std::span<const double> x, residual;
  Kinematics motion;
};

/// The scene at an output time.
struct Snapshot {
  double t;
  std::span<const double> u;
  std::span<const double> x, v;  // over all dofs: positions [m], velocities [m/s]
  ForceMoment forces;  // forces at t if a step ends at t, else at the end of the step that contains t
  // The energy budget at t, or at the end of the last step if outputs are dense; nullptr if no budget is
  // kept.
  const EnergyBudget* budget;
  const MarchState* state;  // state from which a march can be resumed; nullptr: resume from an earlier
                            // snapshot
  std::span<const WinchMoment> winches = {};
  const EnergyJudge* judge = nullptr;  // judges all steps so far; nullptr if no budget is kept
};

/// Report of an accepted step.
struct StepRecord {
  double t, h, end;  // time at the end of the step, its length, time at the end of the march [s]
  std::int64_t steps, rejected;
  double seconds;  // wall time so far
};

struct MarchResult {
  MarchStatus status = MarchStatus::failed;
  std::string reason;  // why the motion ended, as a sentence
  std::vector<double> u;
  double t = 0;
  std::int64_t steps = 0, rejected = 0;
  double shortest = 0, longest = 0;  // shortest and longest accepted step [s]
  StartBalance start;
  double stable_step = 0;  // longest stable step with all members taut [s]; 0: any step is stable
  AchievedAccuracy accuracy;
  Statistics statistics;
};

/// Functions that a march calls to report outputs and steps. Both may be empty.
struct MarchWatch {
  std::function<void(const Snapshot&)> on_output;
  std::function<bool(const StepRecord&, std::span<const double> u)> on_step;  // true: stop the march
};

/// Integrates in time from `from`, or from the start at rest if `from` is nullptr. Steps end at outputs
/// (unless outputs are dense) and at times at which the rate of a guide, a current or a table in time jumps.
/// step_control.hpp determines step lengths, energy_watch.hpp examines the energy of steps. With `check`, the
/// host integrates a second time to estimate the error of the path by (1) of achieved_accuracy.hpp; a second
/// march with steps twice as long costs half as much as the first. A march with energy that nothing supplied
/// (energy_judge.hpp) fails. `limits.work` bounds the work of all steps together, if `limits.model` is given.
MarchResult march(const AssembledScene& scene, const StepMethods& methods, const Limits& limits,
                  const MarchSettings& settings, const MarchWatch& watch, const MarchState* from = nullptr);

}  // namespace netloft
