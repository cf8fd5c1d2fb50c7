// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/convergence.hpp"
#include "framework/balance/work.hpp"

#include <atomic>
#include <limits>

namespace netloft {

struct JudgedPoint;  // assessment.hpp

/// Reason for which the host stopped a solver.
enum class Stop { none, arrived, iterations, time, work, interrupted, ran_away, unsettled };

/// Which properties of an equilibrium are examined, and which equilibria are accepted.
struct Judging {
  bool examine_growth = true;       // examine whether a small disturbance grows, if forces have no energy
  bool accept_oscillation = false;  // accept an equilibrium about which something oscillates
  JudgedPoint* known = nullptr;     // the point whose stability was decided last; null: not stored
};

/// Limits of one solve.
struct Limits {
  double tolerance = kTolerance;  // largest nodal residual over the largest nodal load
  // Chosen for one solve. `auto` continues an attempt that this limit ended.
  int iterations = 1000;
  double seconds = std::numeric_limits<double>::infinity();  // processor time that the user allows
  const std::atomic<bool>* interrupt = nullptr;
  // Largest sum of the lengths of all steps, divided by the gear's size. A gear that exceeds it does not come
  // to rest.
  double path = std::numeric_limits<double>::infinity();
  const WorkModel* model = nullptr;                       // null: work is not limited
  double work = std::numeric_limits<double>::infinity();  // budget, in units of the model
  Judging judging = {};                                   // for the final point

  /// The limit that has been reached by these iterations and seconds and by the operations in `spent`; none
  /// if no limit has been reached.
  Stop reached(int iterations_done, double seconds_spent, const Statistics& spent) const {
    if (interrupt && interrupt->load()) return Stop::interrupted;
    if (iterations_done >= iterations) return Stop::iterations;
    if (seconds_spent >= seconds) return Stop::time;
    if (model && model->of(spent) >= work) return Stop::work;
    return Stop::none;
  }
};

}  // namespace netloft
