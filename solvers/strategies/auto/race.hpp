// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/attempts.hpp"

namespace netloft::automatic {

/// Attempts run in slices of work, all of one length before any of the next longer one:
///   w₀, g w₀, g² w₀, …                                                                   (1)
/// so that none can use up the budget before the others have had a try, and the one that succeeds with work w
/// costs at most about n g w with n attempts (as in M. Luby, A. Sinclair and D. Zuckerman, Optimal speedup of
/// Las Vegas algorithms, Inf. Process. Lett. 47, 1993). One that was cut off at a point of the scene itself
/// goes on from there; one that ended by itself is not tried again from the same start. Where all have ended
/// so, they begin anew from a perturbed start.
class Race {
 public:
  Race(Study& study, const Options& options);

  /// The first stage that converged; else the best there is: an unstable equilibrium before none, then the
  /// smallest residual.
  Stage run();

 private:
  struct Runner {
    Attempt attempt;
    Displacements from;      // where it was cut off; empty: begins anew
    bool has_ended = false;  // by itself
  };

  void run_from_start();
  void run_slice(Runner& runner, double slice);
  void keep_better(Stage stage);
  bool is_decided() const;

  Study& study_;
  const Options& options_;
  Displacements start_;
  std::vector<Runner> runners_;
  Stage best_;
  int fluttering_ = 0;
};

/// A stage in which rounding of the positions is worth more than what is left of the residual goes on with
/// positions that keep their digits; the better of both.
Stage with_compensated_positions(Study& study, const Options& options, Stage stage);

/// Away from an unstable equilibrium along what grows there, or by a perturbation; the better of both.
Stage leave_saddle(Study& study, const Options& options, Stage saddle, double work);

}  // namespace netloft::automatic
