// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/case/case.hpp"

#include <optional>

namespace netloft::io {

/// The cost and the answer of one method at one tolerance.
struct Trial {
  double tolerance = 0;
  bool tried = true;  // false: the method has failed at a looser tolerance already
  SolveStatus status = SolveStatus::not_converged;
  Stability stability = Stability::unknown;
  std::string reason;
  // processor time of the solver, the least of all repeats, without the host's final checks
  double cpu_seconds = 0;
  Statistics statistics;          // of the repeat with that time
  double residual = 0, load = 0;  // recomputed by the host [N]
  // estimate of the error: the next Newton step [m]
  double estimate = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();  // largest node distance to the reference [m]
  double energy = 0;                                        // [J]
  std::vector<double> x, u;                                 // the answer, as in Solution

  bool converged() const {
    return tried && (status == SolveStatus::converged || status == SolveStatus::unstable);
  }
};

/// The solver of a scene, in the form that `--solver` takes.
struct Method {
  std::string specification;  // "newton:method=classic"
};

/// Returns `source` with the overrides of a method and of a tolerance added.
CaseSource source_for(const CaseSource& source, const Method& method, double tolerance);

/// Solves the scene `repeats` times from its initial guess, each time in a new case.
Trial run_trial(const CaseSource& source, Registry& registry, const Method& method, double tolerance,
                int repeats, const Watch& watch);

/// Runs all tolerances from the loosest to the tightest; those after a failure are not tried.
std::vector<Trial> run_trials(const CaseSource& source, Registry& registry, const Method& method,
                              const std::vector<double>& tolerances, int repeats, const Watch& watch);

}  // namespace netloft::io
