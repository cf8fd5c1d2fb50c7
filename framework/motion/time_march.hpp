// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/assembled_scene.hpp"
#include "framework/motion/achieved_accuracy.hpp"
#include "framework/motion/energy_budget.hpp"
#include "framework/motion/march_ending.hpp"
#include "framework/motion/march_settings.hpp"
#include "framework/motion/march_state.hpp"
#include "framework/motion/step_scheme.hpp"
#include "framework/motion/transient_problem.hpp"
#include "framework/motion/winches.hpp"

#include <limits>

namespace netloft {

/// What makes the steps of a march.
struct StepMethods {
  IntegratorChoice integrator;
  SolverChoice solver;  // of implicit steps
};

/// Where forces are asked for, at the end of a step: positions between two ends are smooth but in balance
/// with nothing, and a stiff twine turns their smallest error into a force. Where the forces of a step are
/// means over it, so are the reactions: they are what the momentum of the step came from, while forces at its
/// end ring from step to step with what is too fast for it.
struct ForceMoment {
  double t;                             // [s]
  std::span<const double> x, residual;  // over all dofs: positions [m], reactions of held ones [N]
  Kinematics motion;
};

/// The scene at an output time.
struct Snapshot {
  double t;
  std::span<const double> u;
  std::span<const double> x, v;  // over all dofs: positions [m], velocities [m/s]
  ForceMoment forces;            // at t if a step ends there, else at the end of the step around t
  const EnergyBudget* budget;    // null if it is not kept; of the last step's end if outputs are dense
  const MarchState* state;       // to go on from; null: go on from that of an earlier snapshot
  std::span<const WinchMoment> winches = {};
};

/// A step that was made.
struct StepRecord {
  double t, h, end;  // [s]
  std::int64_t steps, rejected;
  double seconds;  // wall time so far
};

/// How far the beginning was from an equilibrium: forces at rest there, by node.
struct StartBalance {
  double residual = 0, load = 0;  // largest that is out of balance, largest load on a node [N]
  std::string node;               // that of the residual; empty: not known, the march went on from a file
};

struct MarchResult {
  MarchStatus status = MarchStatus::failed;
  std::string reason;  // a sentence
  std::vector<double> u;
  double t = 0;
  std::int64_t steps = 0, rejected = 0;
  double shortest = 0, longest = 0;  // steps that were made [s]
  StartBalance start;
  double stable_step = 0;  // longest stable one with all members taut [s]; 0: any is
  AchievedAccuracy accuracy;
  Statistics statistics;
};

/// Who looks on. Both may be empty.
struct MarchWatch {
  std::function<void(const Snapshot&)> on_output;
  std::function<bool(const StepRecord&, std::span<const double> u)> on_step;  // true: stop here
};

/// Goes through time from `from`, or from the start at rest if that is null. Steps end at outputs (unless
/// they are dense) and where a guide, the current or a table in time has a corner. step_control.hpp says how
/// long they are, energy_watch.hpp how their energy is looked at.
/// With `check` the host goes through time a second time, to know the error of the path by (1) of
/// achieved_accuracy.hpp; that costs half as much again where the other's steps are twice as long. A march
/// whose energy comes out of nothing (energy_judge.hpp) has failed, however smoothly it steps on.
/// `limits.work` bounds all steps together, where there is a model of it.
MarchResult march(const AssembledScene& scene, const StepMethods& methods, const Limits& limits,
                  const MarchSettings& settings, const MarchWatch& watch, const MarchState* from = nullptr);

}  // namespace netloft
