// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/energy_judge.hpp"
#include "framework/motion/march_settings.hpp"
#include "framework/motion/march_state.hpp"
#include "framework/motion/transient_problem.hpp"

namespace netloft {

/// Looks at the energy of the steps of a march: of all where a budget is kept, else of some. A scheme sees a
/// snap by the forces it asks for, and not what lies between the places where it does. So each step is held
/// to its energy as well, by the energy budget, with given and W of energy_judge.hpp at its end:
///   |Δnumerical| ≤ accuracy (given + W)                                                     (1)
/// What a snap takes or makes falls with h, not with its cube as the error of a step: held to that alone, a
/// chain was followed in steps of 1e-7 s at an accuracy of 5e-5, and lost. Without an energy budget only
/// every 16th step is looked at where stability makes steps short.
class EnergyWatch {
 public:
  /// `makes_short_steps`: by stability, and so many.
  EnergyWatch(Assembler& assembler, const MarchSettings& settings, bool makes_short_steps);

  /// From a state on; `negligible` is W [J]. False: see the assembler's fault().
  bool begin(const MarchState& from, double negligible);
  /// Whether the energy of the next step is asked for.
  bool watches_step_after(const MarchState& state) const;
  /// Looks at a step that is tried: from one state to another at time t. Raises its error, over what is
  /// tolerated, to that by (1). False: see the assembler's fault().
  bool look(TransientProblem& problem, const MarchState& from, const MarchState& to, double t, double& error);
  /// The step that was looked at is made.
  void accept() { judge_ = tried_; }
  /// The same state, whose rotations are counted in another way now.
  bool restate(const MarchState& state);
  /// Keeps what a march goes on from; `refreshes`: elements remember that state by now.
  void keep_in(MarchState& state, bool refreshes);

  /// Energy came out of nothing.
  bool is_lost(bool at_the_end) const { return settings_.judged && judge_.is_lost(at_the_end); }
  std::string sentence() const { return judge_.sentence(); }
  /// Null: it is not kept.
  const EnergyBudget* budget() const { return settings_.budget ? &budget_ : nullptr; }

 private:
  double steps_per_look() const;
  double tolerated() const;

  const MarchSettings& settings_;
  bool makes_short_steps_;
  EnergyBudget budget_;
  EnergyJudge judge_, tried_;  // tried_: with the step that is tried
};

}  // namespace netloft
