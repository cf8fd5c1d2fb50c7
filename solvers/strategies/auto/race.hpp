// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/attempts.hpp"

#include <vector>

namespace netloft::automatic {

/// Attempts run in slices of work, all of one length before any of the next longer one but for what is nearly
/// in balance:
///   w₀, g w₀, g² w₀, …,   g = 2                                                          (1)
/// so that none can use up the budget before the others have had a try, and the one that succeeds with work w
/// costs at most about n w g² / (g − 1) with n attempts, which is least with this g, where w is at least w₀,
/// no saddle is met and no attempt is nearly in balance (as in M. Luby, A. Sinclair and D. Zuckerman, Optimal
/// speedup of Las Vegas algorithms, Inf. Process. Lett. 47, 1993). README.md tells the rules.
class Race {
 public:
  Race(Study& study, const Options& options);

  /// The first stage that converged; else an unstable equilibrium, of several the one that balances best;
  /// else an empty stage.
  Stage run();

 private:
  struct Runner {
    Attempt attempt;
    bool is_out = false;   // not tried again
    bool is_near = false;  // cut off where the scene is nearly in balance
  };

  void run_round(double slice);
  void run_slice(Runner& runner, double slice);
  Stage off_saddle(Stage saddle, double work);
  Stage with_compensated_positions(Stage stage);
  void look_on_for_as_much_again();
  void keep_better(Stage stage);
  bool is_decided() const;

  Study& study_;
  const Options& options_;
  double budget_;       // work that was left when the race began
  double over_at_ = 0;  // work left at which the race is over
  Displacements start_;
  std::vector<Runner> runners_;
  Stage best_;  // of those that are stationary
};

}  // namespace netloft::automatic
