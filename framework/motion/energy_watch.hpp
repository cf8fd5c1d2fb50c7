// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/energy_judge.hpp"
#include "framework/motion/march_settings.hpp"
#include "framework/motion/march_state.hpp"
#include "framework/motion/transient_problem.hpp"

namespace netloft {

/// Examines the energy of the steps of a march (an integration in time): all steps if an energy budget is
/// kept, otherwise some. A scheme can miss the snap of a rope between two points at which it evaluates
/// forces. Therefore the energy of an examined step must satisfy, with `given` and W of energy_judge.hpp at
/// its end,
///   |Δnumerical| ≤ accuracy (given + W)                                                     (1)
/// Δnumerical is the energy that the scheme takes out of the motion in the step. The energy that a snap takes
/// or creates is proportional to the step length h, whereas the error of a step is proportional to h³. With
/// control of the error alone, a chain needed steps of 1e-7 s at an accuracy of 5e-5, and still failed. If no
/// budget is kept and stability requires short steps, every 16th step is examined.
class EnergyWatch {
 public:
  /// `makes_short_steps`: whether stability requires short steps.
  EnergyWatch(Assembler& assembler, const MarchSettings& settings, bool makes_short_steps);

  /// Begins at a state; `negligible` is W of (1) [J]. Returns false if an element failed, see
  /// Assembler::fault.
  bool begin(const MarchState& from, double negligible);
  /// Whether the energy of the step after this state will be examined.
  bool watches_step_after(const MarchState& state) const;
  /// Examines an attempted step, from one state to another at time t. On input, `error` is the error of the
  /// step divided by its tolerance. On output, `error` is at least the left side of (1) divided by the right
  /// side. Returns false if an element failed, see Assembler::fault.
  bool examine(TransientProblem& problem, const MarchState& from, const MarchState& to, double t,
               double& error);
  void accept() { judge_ = tried_; }
  /// Replaces the rotation vectors of bodies in the last state by shorter vectors of the same rotations.
  bool restate(const MarchState& state);
  /// Stores the sums that a resumed march needs in the state of the march. `refreshes`: elements have stored
  /// the state in their memory, so that their forces have to be evaluated again.
  void keep_in(MarchState& state, bool refreshes);

  /// Whether the motion contains energy that nothing supplied.
  bool is_lost(bool at_the_end) const { return settings_.judged && judge_.is_lost(at_the_end); }
  std::string sentence() const { return judge_.sentence(); }
  /// The budget; nullptr if none is kept.
  const EnergyBudget* budget() const { return settings_.budget ? &budget_ : nullptr; }
  /// The judge of all steps so far; nullptr if no budget is kept.
  const EnergyJudge* judge() const { return settings_.budget ? &judge_ : nullptr; }

 private:
  double steps_per_examination() const;
  double tolerated() const;

  const MarchSettings& settings_;
  bool makes_short_steps_;
  EnergyBudget budget_;
  EnergyJudge judge_, tried_;  // tried_ is judge_ after the attempted step
};

}  // namespace netloft
