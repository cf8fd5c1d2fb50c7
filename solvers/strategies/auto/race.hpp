// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/strategies/auto/attempts.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace netloft::automatic {

/// A budget of work: all work that is left for a search, or a part of it.
class Budget {
 public:
  explicit Budget(Search& search, double end = 0) : search_(search), begun_(search.work_left()), end_(end) {}

  double spent() const { return begun_ - search_.work_left(); }
  double left() const { return search_.work_left() - end_; }
  bool is_used_up() const { return left() <= 0; }
  /// Returns a budget for a part of the work that is left: at most `work`.
  Budget split(double work) const { return Budget(search_, std::max(end_, search_.work_left() - work)); }
  /// Ends after this much more work, unless an end has been set before.
  void end_after(double work) {
    if (end_ == 0) end_ = std::max(0.0, search_.work_left() - work);
  }

 private:
  Search& search_;
  double begun_, end_;  // work left in the search at the start and at the end of this budget
};

/// Runs attempts in slices of work, so that no attempt can use up the budget before the others have been
/// tried. All slices of one round have the same length; those of the next round are longer. An attempt that
/// was cut off close to balance gets its longer slice at once. The lengths are
///   w₀, g w₀, g² w₀, …,   g = 2                                                          (1)
/// Suppose that one of n attempts succeeds with work w ≥ w₀, that no saddle is met, and that no attempt is
/// cut off close to balance. The race then costs at most about n w g²/(g − 1), which is least with this g (as
/// in M. Luby, A. Sinclair and D. Zuckerman, Optimal speedup of Las Vegas algorithms, Inf. Process. Lett. 47,
/// 1993). README.md explains the rules.
class Race {
 public:
  Race(Search& search, const Options& options);

  /// Returns the first stage that converged, otherwise the best unstable equilibrium (keep_better), otherwise
  /// an empty stage.
  Stage run();
  /// The start of all attempts: that of the search, slightly perturbed if forces are undefined there.
  const Displacements& start() const { return start_; }

 private:
  /// The sequel of a slice for its attempt: nothing more (`out`), a slice in the next round (`again`) or, if
  /// it was cut off close to balance, a slice of double length at once (`again_at_once`).
  enum class Fate { out, again, again_at_once };
  struct Runner {
    Attempt attempt;
    Fate fate = Fate::again;
  };

  /// An unstable equilibrium, and the searches on its two sides. is_tried: whether the search on a side has
  /// ended, so that more work would not change its result.
  struct Saddle {
    Stage stage;
    std::array<bool, 2> is_tried{};
  };

  void run_round(double slice);
  void run_slice(Runner& runner, double slice);
  Stage off_saddle(Stage stage, const Budget& budget);
  std::size_t find_saddle(Stage stage);
  std::optional<Stage> leave(std::size_t at, const Budget& budget);
  Stage with_compensated_positions(Stage stage);
  void keep_better(const Stage& stage);
  bool is_decided() const;

  Search& search_;
  const Options& options_;
  Budget budget_;
  Displacements start_;
  std::vector<Runner> runners_;
  std::vector<Saddle> saddles_;  // all saddles that were met, so that none is left twice
  Stage best_;                   // the best equilibrium so far
};

}  // namespace netloft::automatic
