// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/convergence.hpp"
#include "framework/balance/work.hpp"

#include <atomic>
#include <limits>

namespace netloft {

struct JudgedPoint;  // assessment.hpp

/// Why a solver was told to stop.
enum class Stop { none, arrived, iterations, time, work, interrupted, ran_away, unsettled };

/// What of an equilibrium is asked, and what is accepted as one.
struct Judging {
  bool ask_growth = true;        // whether a small disturbance grows, where forces have no energy
  bool accept_swinging = false;  // whether one about which something swings is an answer
  JudgedPoint* known = nullptr;  // the one whose stability was decided last; null: not kept
};

/// When to stop.
struct Limits {
  double tolerance = kTolerance;  // largest nodal residual over the largest nodal load
  // Chosen: of one solve. `auto` goes on with what it ends.
  int iterations = 1000;
  double seconds = std::numeric_limits<double>::infinity();  // of the processor that the user allows
  const std::atomic<bool>* interrupt = nullptr;
  // that its nodes may go in all steps together, over the gear's size: what goes farther has no rest
  double path = std::numeric_limits<double>::infinity();
  const WorkModel* model = nullptr;                       // null: work is not limited
  double work = std::numeric_limits<double>::infinity();  // budget, in units of the model
  Judging judging = {};                                   // of the point where it stopped

  /// Which of them is reached after so many iterations and seconds, and what was spent in all.
  Stop reached(int iterations_done, double seconds_spent, const Statistics& spent) const {
    if (interrupt && interrupt->load()) return Stop::interrupted;
    if (iterations_done >= iterations) return Stop::iterations;
    if (seconds_spent >= seconds) return Stop::time;
    if (model && model->of(spent) >= work) return Stop::work;
    return Stop::none;
  }
};

}  // namespace netloft
