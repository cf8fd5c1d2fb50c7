// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "solvers/methods/newton/direction.hpp"
#include "solvers/methods/newton/iterate.hpp"
#include "solvers/methods/newton/nearly_definite.hpp"
#include "solvers/methods/newton/negative_curvature.hpp"
#include "solvers/methods/newton/newton.hpp"
#include "solvers/methods/newton/step.hpp"

namespace netloft::newton {

/// −r·s is what a step s would lower a linear energy by. It has to halve within as many steps as a search may
/// spend on one, or the steps go round in rounding.
class StallCount {
 public:
  explicit StallCount(std::int64_t most_steps) : most_steps_(most_steps) {}
  /// Counts one more step, and tells whether they have stalled.
  bool stalls_with(double decrease);
  void reset() {
    least_ = std::numeric_limits<double>::infinity();
    steps_without_halving_ = 0;
  }

 private:
  std::int64_t most_steps_, steps_without_halving_ = 0;     // in a row
  double least_ = std::numeric_limits<double>::infinity();  // decrease that was the last to halve it
};

/// Steps that promise to gain less than the energy's rounding, where it cannot tell whether they gain
/// anything.
class RoundOffSteps {
 public:
  RoundOffSteps(const Newton::Parameters& parameters, Problem& problem, NearlyDefinite& nearly_definite,
                NegativeCurvature& curvature);

  /// Moves u by the whole of s if that does not raise ‖r‖; else, undamped, by (7).
  Step take(Iterate& iterate, const Direction& direction);
  /// Where damping leads nowhere, once at every point: by Newton's own step; or where all forces have an
  /// energy and K is nearly definite, off the saddle; or where nothing curves downwards, either, by a step of
  /// K + σ M.
  Step fall_back(Iterate& iterate, double damping);
  /// (7) may be tried again: u has moved by the energy.
  void reset_stall_count() { stall_.reset(); }

 private:
  bool may_fall_back(Iterate& iterate, double damping) const;
  Step take_with_another_matrix(Iterate& iterate);
  Step take_newton_step(Iterate& iterate);
  Step take_by_slope(Iterate& iterate, std::span<const double> s, double damping);
  std::span<const double> solve(Iterate& iterate);

  const Newton::Parameters& p_;
  NearlyDefinite& nearly_definite_;
  NegativeCurvature& curvature_;
  StallCount stall_;
  std::optional<std::size_t> fell_back_at_;  // count of points
  std::vector<double> s_;                    // of fall_back; reserved
};

}  // namespace netloft::newton
