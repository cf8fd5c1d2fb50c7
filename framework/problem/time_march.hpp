// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include "framework/problem/energy_judge.hpp"
#include "framework/problem/transient_problem.hpp"
#include "framework/problem/winches.hpp"

namespace netloft {

/// How time is gone through.
struct MarchSettings {
  double duration = 0;  // [s]
  double step = 0;      // first or only one [s]; 0: found
  bool adaptive = true;
  double accuracy = 1e-3;  // of the path: errors of single steps by (2), over the longest element
  double longest_step = std::numeric_limits<double>::infinity();  // [s]
  double shortest_step = 1e-9;                                    // [s]
  double output_interval = 0;                                     // [s]; 0: the beginning and the end
  bool dense = false;       // outputs between steps; otherwise steps end at them
  bool budget = true;       // keep the energy budget
  bool judged = true;       // fail once there is energy that nobody gave
  bool check = false;       // compare with another march, in steps `pace` times as long
  double pace = 1;          // factor on all lengths of steps
  double mass_damping = 0;  // c of the force −c M v [1/s]
};

/// An integrator with its parameters.
struct IntegratorChoice {
  const IntegratorType* type = nullptr;
  const void* parameters = nullptr;
};

/// All that the rest of a march follows from, to the bit: what is kept to go on later.
struct MarchState {
  double t = 0, h = 0;                      // reached, and the step that was wanted next [s]
  std::vector<double> u, v, a;              // of the unknowns [m], [m/s], [m/s²]
  std::vector<double> memory;               // of the elements
  std::vector<double> budget;               // sums of it [J]
  std::vector<double> judged;               // sums of who judges it [J]
  std::vector<double> winches;              // Winches::state()
  double error_sum = 0, largest_error = 0;  // of steps, over the longest element
  double largest_at = 0;                    // time of the largest [s]
  std::uint64_t largest_of = 0;             // and its node
  double least_load = 0;                    // [N]
  double stable_step = 0;                   // by the tangent when it was last asked for [s]; 0: not yet
  std::size_t outputs = 0;                  // written before
  std::int64_t steps = 0, rejected = 0;
  double t_before = 0;  // begin of the last step, of a march that is compared between steps [s]
  std::vector<double> u_before, v_before;  // there [m], [m/s]
  std::vector<MarchState> other;           // the march that this one is compared with, if it is
  // largest so far by (3) [m], its time [s]; NaN: not compared yet
  double path_error = std::numeric_limits<double>::quiet_NaN(), path_at = 0;
  std::uint64_t path_of = 0;  // and its node
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

enum class MarchStatus { finished, stopped, failed, out_of_time, out_of_work, interrupted };
const char* name_of(MarchStatus status);

/// How far the beginning was from an equilibrium: forces at rest there, by node.
struct StartBalance {
  double residual = 0, load = 0;  // largest that is out of balance, largest load on a node [N]
  std::string node;               // that of the residual; empty: not known, the march went on from a file
};

/// What control of the error came to, over the longest element, where steps are adaptive.
struct AchievedAccuracy {
  double asked = 0;    // accuracy of the path
  double element = 0;  // the longest, along one axis [m]
  double allowed = 0;  // error of one step by (2)
  double largest = 0;  // estimated for an accepted step, at time t and of a node
  double t = 0;        // [s]
  std::string node = {};
  double sum = 0;  // of the largest errors of all steps: that of the path, if no motion enlarges or damps it
  bool is_checked = false;  // against another march: what follows is known
  // error of the path by (3), at a time and of a node; infinite: the other was lost; NaN: not told, for its
  // steps were the same
  double path = 0;
  double path_at = 0;  // [s]
  std::string path_of = {};
  /// The path is not known as well as was asked for.
  bool is_missed() const { return is_checked && !(path <= asked); }
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
/// they are dense) and where a guide, the current or a table in time has a corner. With error control, a step
/// is rejected if its estimate exceeds the accuracy, and the next one is
///   h ← h · 0.9 (accuracy/error)^(1/order), within [1/5, 2] h                              (1)
/// Where the error of a step is of order p in h, sums over the steps of a path fall with the power (p − 1)/p
/// of what is allowed for one. Paths shall be as accurate as is asked, so that below a, 1e-2,
///   allowed = a (accuracy/a)^(p/(p − 1)),  p = 2 with members that go slack and taut     (2)
/// (tolerance proportionality: M. Calvo, D. J. Higham, J. I. Montijano, L. Rández, "Stepsize selection for
/// tolerance proportionality in explicit Runge-Kutta codes", Adv. Comput. Math. 7, 1997).
/// A scheme sees a snap by the forces it asks for, and not what lies between the places where it does. So
/// each step is held to its energy as well, by the energy budget, with given and W of energy_judge.hpp at its
/// end:
///   |Δnumerical| ≤ accuracy (given + W)                                                     (4)
/// What a snap takes or makes falls with h, not with its cube as the error of a step: held to (2), a chain
/// was followed in steps of 1e-7 s at an accuracy of 5e-5, and lost.
/// Errors of single steps say nothing of a motion that enlarges them, or of steps that are given. With
/// `check` the host goes through time a second time, in steps r times as long (2, or ½ where stability bounds
/// them), and takes for the error of the path
///   the largest distance of a node between both at an output / min(1, |r − 1|)                  (3)
/// r as the mean steps were; where they differ by less than a tenth, nothing is told, and if that is so at
/// all outputs the error is not known. It is not below the error where that falls with the step by the power
/// 1 or more; in a motion that errors have taken over, both are off alike, and so is their difference. Costs
/// half as much again for r = 2. A march whose energy comes out of nothing (energy_judge.hpp) has failed,
/// however smoothly it steps on. `limits.work` bounds all steps together, where there is a model of it.
/// Without an energy budget only every 16th step is looked at where stability makes steps short.
MarchResult march(const Scene& scene, Assembler& assembler, IntegratorChoice integrator, SolverChoice solver,
                  const MakeFactorisation& make, const Limits& limits, const MarchSettings& settings,
                  const MarchWatch& watch, const MarchState* from = nullptr);

/// At rest where the scene starts, or with displacements u of its unknowns.
MarchState state_at_rest(const Assembler& assembler, std::span<const double> u = {});

}  // namespace netloft
