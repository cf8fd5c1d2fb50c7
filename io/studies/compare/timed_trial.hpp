// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

#include <optional>

namespace netloft::studies {

/// The cost and the answer of one method at one tolerance. For a motion the tolerance is the accuracy of its
/// path.
struct Trial {
  double tolerance = 0;
  bool tried = true;    // false if the method has already failed at a looser tolerance
  bool failed = false;  // whether its plugin broke down; `reason` has the error
  SolveStatus status = SolveStatus::not_converged;
  Stability stability = Stability::unknown;
  std::string reason;  // why there is no answer, as a sentence
  // How a motion ended: "finished", "lost", "out of time", "out of work", "interrupted"; empty: no motion.
  std::string of_motion;
  // Processor time of the solver in the fastest repeat, without the final checks by the host.
  double cpu_seconds = 0;
  Statistics statistics;          // statistics of the fastest repeat
  double residual = 0, load = 0;  // largest residual and load of a node at the answer [N]
  // Estimated error: the largest displacement of a node in the next Newton step [m].
  double estimate = std::numeric_limits<double>::quiet_NaN();
  // Largest distance of a node from the reference; for a motion, over all outputs [m].
  double error = std::numeric_limits<double>::quiet_NaN();
  double energy = 0;                      // [J]
  std::vector<double> x, u;               // positions and displacements, as in Solution
  std::vector<std::vector<double>> path;  // path of a motion: x at every output
  std::int64_t steps = 0, rejected = 0;   // accepted and rejected time steps of a motion
  bool is_damped = true;                  // whether loss factors of materials were used

  std::string outcome() const {
    if (!tried) return "not tried";
    if (failed) return "failed";
    return of_motion.empty() ? std::string(name_of(status)) : of_motion;
  }
  bool converged() const {
    return tried && (status == SolveStatus::converged || status == SolveStatus::unstable);
  }
};

/// A compared method: a solver in the syntax of `--solver`, or the word `strategy` or `integrator` with its
/// name.
struct Method {
  std::string specification;  // such as "newton:method=classic", "strategy auto", "integrator newmark"

  /// "solver", "strategy" or "integrator", which is also its key in the table [analysis] of a scene.
  std::string kind() const;
  /// The specification without its keyword: "auto" for "strategy auto".
  std::string name() const;
};

/// Returns `source` with this method and tolerance.
runs::CaseSource source_for(const runs::CaseSource& source, const Method& method, double tolerance);

/// Solves the scene `repeats` times from its initial guess; the scene is read anew each time. If the method
/// is an integrator, computes the motion of the scene instead, within the work budget of the analysis.
Trial run_trial(const runs::CaseSource& source, Registry& registry, const Method& method, double tolerance,
                int repeats, const runs::Watch& watch);

/// Runs all tolerances from the loosest to the tightest. After a failure, tighter tolerances are skipped,
/// except for motions, because shorter steps may succeed.
std::vector<Trial> run_trials(const runs::CaseSource& source, Registry& registry, const Method& method,
                              const std::vector<double>& tolerances, int repeats, const runs::Watch& watch);

}  // namespace netloft::studies
