// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/continuation/easier.hpp"
#include "framework/problem/verdict.hpp"
#include "framework/scene/plan.hpp"

#include <optional>

namespace netloft {

/// A solver and the values of its parameters.
struct SolverUse {
  const SolverType* type = nullptr;
  Values parameters;
};

/// A start for the scene itself that whoever calls can find by what nothing here knows: what its elements
/// are.
struct OwnStart {
  std::string name;
  bool soon = false;  // before all other ways, after fewer iterations of the scene itself
  /// From displacements (empty: the sketch), within so many seconds; what was solved is added to `legs`.
  std::function<std::optional<std::vector<double>>(const std::vector<double>& from, double seconds,
                                                   std::vector<Leg>& legs)>
      find;
};

/// How a journey is made.
struct JourneyOptions {
  SolverUse solver;
  std::optional<SolverUse> nearby;  // in its place from the start that the journey is given, if any
  Limits limits;
  MakeFactorisation make;
  TangentChoice tangent = TangentChoice::exact;
  int threads = 1;
  bool detours = true;  // else the scene itself only
  int looks = 0;        // for other shapes, from the one that was found
  // In the place of a number: some after a long way or an own start, as long as they cost little.
  static constexpr int kLooksThatSuit = -1;
  std::function<void(const IterationRecord&)> on_iteration;
  OwnStart own_start;  // none: no such way
};

/// Solves a scene from its start, and where that does not arrive, over easier scenes: each is solved in turn
/// and the next one starts where it ended. Any solver will do; it never knows. What the easier scenes are is
/// told by the roles of parameters and by the water, so that nothing here knows of nets.
///   no compression   tension only is a convex problem under dead loads (Priour 2013)
///   soft to stiff    stiffness capped, the cap raised step by step
///   slow to fast     the current from none to all of it, by steps that halve when one fails
///   shaken           off a point that is not stable, or that has no forces
///   moved            along the motion that its linear stiffness resists, off points that are not stable, too
///   relaxed          a matrix-free solver brings it near, if one is there
///   own              a start that whoever calls can find
/// Only the scene itself, last of all, is judged. Whether it stands in other ways, too, is looked for from
/// where it stands.
class Journey {
 public:
  Journey(const Scene& scene, Assembler& assembler, Registry& registry, JourneyOptions options);

  /// The scene itself from displacements `start` of its unknowns (empty: from its sketch), then the detours
  /// that promise something, until one arrives at an equilibrium that is not unstable.
  Solution arrive(std::vector<double> start);

  /// What was solved before the scene itself, on `leg` for instance a coarser mesh; counts with the rest.
  void book(const Leg& leg);

 private:
  using Displacements = std::vector<double>;

  /// Where the scene itself is to start from, given where it started at first and the best so far.
  struct Way {
    const char* name;
    std::optional<Displacements> (Journey::*to)(const Displacements& start, const Solution& best);
  };

  std::vector<Way> ways_from(const Displacements& start) const;
  double stretch_of_stiffest() const;
  bool is_stiff() const;
  bool sticks() const;
  void be_patient(const Solution& first, const Limits& limits);
  void go_further(Solution& best, const std::string& name, const Limits& limits);
  void try_other_ways(Solution& best, const std::vector<Way>& ways, const Displacements& start,
                      const Limits& limits);
  void gain_digits(Solution& best);
  void tell_of_restlessness(Solution& best) const;
  bool comes_on(const Solution& now, const Solution& before) const;
  void try_once_more(Solution& best, const Displacements& start, const Limits& before);

  std::optional<Displacements> over_nothing(const Displacements& start, const Solution& best);
  std::optional<Displacements> over_shaking(const Displacements& start, const Solution& best);
  std::optional<Displacements> over_own_start(const Displacements& start, const Solution& best);
  std::optional<Displacements> over_tension_only(const Displacements& start, const Solution& best);
  std::optional<Displacements> over_stiffness(const Displacements& start, const Solution& best);
  std::optional<Displacements> over_current(const Displacements& start, const Solution& best);
  std::optional<Displacements> over_motion(const Displacements& start, const Solution& best);
  std::optional<Displacements> over_more_motion(const Displacements& start, const Solution& best);
  std::optional<Displacements> over_relaxation(const Displacements& start, const Solution& best);

  Displacements shaken(Displacements u, double share) const;
  Displacements grown(const Solution& s);
  Displacements away_from(const Solution& saddle);
  std::optional<Solution> move(const Displacements& start);
  void leave_saddles(Solution& s, const std::string& name, const Limits& limits);
  bool may_well_stand_otherwise(const Solution& best) const;
  double imbalance(const Scene& scene, const Displacements& u) const;
  void look_for_other_shapes(Solution& best, const Displacements& start, const Limits& limits);
  Displacements start_of_look(int look, const Displacements& start, const Solution& best);
  double work() const;
  Solution solve_itself_off_saddles(const std::string& name, const Displacements& start,
                                    const Limits& limits);
  Solution solve_itself(const std::string& name, const Displacements& start, const Limits& limits);
  Solution solve_itself(const std::string& name, const SolverUse& solver, const Displacements& start,
                        const Limits& limits, Digits digits = Digits::of_doubles);
  Solution solve_leg(const std::string& name, const Scene& easier, const SolverUse& solver,
                     const Displacements& start, double tolerance, int iterations = 0);
  Displacements stiffened(Displacements u, double cap, double stiffest);
  Solution solve_stage(const Displacements& start, double cap);
  std::optional<SolverUse> other_solver(const std::string& name) const;
  Limits limits_of_leg(double tolerance, int iterations) const;
  double seconds_left() const;
  double patience_left() const;
  bool out_of_time() const;
  Solution finish(Solution solution) const;

  // Whoever is to leave a saddle is shaken by this share of an element's size.
  static constexpr double kLeaveShare = 0.02;
  // What has gone so many times the gear's size, round and round or away, goes on: motions of the hard cases
  // that came to rest (40, draws 11 to 54) had gone up to 6.3 times that, most others 20 to 80 times by their
  // end.
  static constexpr double kLongestWay = 10;

  const Scene& scene_;
  Assembler& assembler_;
  Registry& registry_;
  JourneyOptions options_;
  double begun_, begun_cpu_ = 0, patience_, leg_patience_;  // by the wall and of the processor [s]
  double leg_way_ = Limits{}.way;                           // over the gear's size
  std::vector<Leg> legs_;
  double stretch_ = 1;  // of the stiffest part, under all that drives the gear
  bool is_conservative_ = true;
  bool is_nearby_ = false;  // what is solved next is the scene itself from the start that was given
  bool may_move_ = true;
  double side_ = -1;                // to which it went aside the last time
  int turn_ = 0;                    // each has its own way of shaking
  int motions_ = 0, restless_ = 0;  // and how many were given up because they went on and on
  Displacements relaxed_;           // where a matrix-free solver brought it; empty: was not asked
  Displacements moved_;             // where it was still moving; empty: it came to rest, or was not asked
};

}  // namespace netloft
