// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

#include <optional>

namespace netloft::studies {

/// The cost and the answer of one method at one tolerance; of a motion that is the accuracy of its path.
struct Trial {
  double tolerance = 0;
  bool tried = true;    // false: the method has failed at a looser tolerance already
  bool failed = false;  // its plugin did, with an error that `reason` says
  SolveStatus status = SolveStatus::not_converged;
  Stability stability = Stability::unknown;
  std::string reason;     // a sentence
  std::string of_motion;  // "finished", "lost", "out of time", "out of work" or "interrupted"; empty: it is
                          // an equilibrium
  // processor time of the solver, the least of all repeats, without the host's final checks
  double cpu_seconds = 0;
  Statistics statistics;          // of the repeat with that time
  double residual = 0, load = 0;  // recomputed by the host [N]
  // estimate of the error: the next Newton step [m]
  double estimate = std::numeric_limits<double>::quiet_NaN();
  // largest node distance to the reference, of a motion at any output [m]
  double error = std::numeric_limits<double>::quiet_NaN();
  double energy = 0;                      // [J]
  std::vector<double> x, u;               // the answer, as in Solution
  std::vector<std::vector<double>> path;  // of a motion: x at every output
  std::int64_t steps = 0, rejected = 0;   // of a motion, in time
  bool is_damped = true;                  // loss factors of materials count in the motion, or no part has one

  std::string outcome() const {
    if (!tried) return "not tried";
    if (failed) return "failed";
    return of_motion.empty() ? std::string(name_of(status)) : of_motion;
  }
  bool converged() const {
    return tried && (status == SolveStatus::converged || status == SolveStatus::unstable);
  }
};

/// A method that is compared: a solver in the form of `--solver`, or a strategy or an integrator behind that
/// word.
struct Method {
  std::string specification;  // "newton:method=classic", "strategy auto", "integrator newmark"

  /// "solver", "strategy" or "integrator", as the keys of an analysis are called.
  std::string kind() const;
  /// The specification without that word.
  std::string name() const;
};

/// Returns `source` with a method and a tolerance chosen.
runs::CaseSource source_for(const runs::CaseSource& source, const Method& method, double tolerance);

/// Solves the scene `repeats` times from its initial guess, each time in a new case; with an integrator, goes
/// through time, as far as the budget of work of the analysis leads.
Trial run_trial(const runs::CaseSource& source, Registry& registry, const Method& method, double tolerance,
                int repeats, const runs::Watch& watch);

/// Runs all tolerances from the loosest to the tightest; those after a failure are not tried, but for
/// motions, which shorter steps may save.
std::vector<Trial> run_trials(const runs::CaseSource& source, Registry& registry, const Method& method,
                              const std::vector<double>& tolerances, int repeats, const runs::Watch& watch);

}  // namespace netloft::studies
