// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/convergence.hpp"
#include "framework/balance/work.hpp"

#include <atomic>
#include <limits>

namespace netloft {

struct JudgedPoint;  // defined in assessment.hpp

/// Why the host stopped a solver.
enum class Stop { none, arrived, iterations, time, work, interrupted, ran_away, unsettled };

/// How the final point of a solver is assessed.
struct Judging {
  bool examine_growth = true;       // examine whether disturbances grow, if forces have no potential
  bool accept_oscillation = false;  // accept an equilibrium from which an oscillation grows
  JudgedPoint* known = nullptr;  // the last point whose stability was decided, for reuse; nullptr: no reuse
};

struct Limits {
  double tolerance = kTolerance;  // largest nodal residual over the largest nodal load
  // Largest number of iterations of one solve. This does not limit a strategy, which may continue from the
  // final point of a solve.
  int iterations = 1000;
  double seconds = std::numeric_limits<double>::infinity();  // processor time that the user allows
  const std::atomic<bool>* interrupt = nullptr;
  // Upper limit of the path (the sum of the lengths of all steps), divided by the gear's size. A gear with a
  // longer path does not come to rest.
  double path = std::numeric_limits<double>::infinity();
  const WorkModel* model = nullptr;                       // nullptr: work is not limited
  double work = std::numeric_limits<double>::infinity();  // budget, in units of the model
  Judging judging = {};                                   // how the final point is assessed

  /// Returns the limit that has been reached after this number of iterations, this processor time and the
  /// operations in `spent`.
  Stop reached(int iterations_done, double seconds_spent, const Statistics& spent) const {
    if (interrupt && interrupt->load()) return Stop::interrupted;
    if (iterations_done >= iterations) return Stop::iterations;
    if (seconds_spent >= seconds) return Stop::time;
    if (model && model->of(spent) >= work) return Stop::work;
    return Stop::none;
  }
};

}  // namespace netloft
