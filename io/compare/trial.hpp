// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/analysis/case.hpp"

#include <optional>

namespace netloft::io {

/// One method at one tolerance: what it cost, and where it ended.
struct Trial {
  double tolerance = 0;
  bool tried = true;  // false: a looser tolerance was not reached already
  SolveStatus status = SolveStatus::not_converged;
  Stability stability = Stability::unknown;
  std::string reason;
  double cpu_seconds = 0;  // of the solver, the least of all repeats; the host's last checks are not in it
  Books books;             // of that repeat
  double residual = 0, load = 0;                               // recomputed by the host [N]
  double estimate = std::numeric_limits<double>::quiet_NaN();  // of its error, from the step that is left [m]
  double error = std::numeric_limits<double>::quiet_NaN();     // largest node distance to the reference [m]
  double energy = 0;                                           // [J]
  std::vector<double> x, u;                                    // where it ended, as in Solution

  bool arrived() const {
    return tried && (status == SolveStatus::converged || status == SolveStatus::unstable);
  }
};

/// A scene, and who solves it: each of the words that `--solver` takes.
struct Method {
  std::string word;  // "newton:method=classic"
};

/// `source` with the overrides of a method and of a tolerance on top.
CaseSource source_for(const CaseSource& source, const Method& method, double tolerance);

/// Solves the scene `repeats` times from its start, each time in a case of its own.
Trial run_trial(const CaseSource& source, Registry& registry, const Method& method, double tolerance,
                int repeats, const Watch& watch);

/// From the loosest tolerance to the tightest; those beyond one that was not reached are not tried.
std::vector<Trial> run_trials(const CaseSource& source, Registry& registry, const Method& method,
                              const std::vector<double>& tolerances, int repeats, const Watch& watch);

}  // namespace netloft::io
