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

/// Detects steps that only follow rounding errors. The decrease −r·s that a step s promises has to halve
/// within `refinements` steps; otherwise the steps have stalled.
class StallCount {
 public:
  explicit StallCount(std::int64_t most_steps) : most_steps_(most_steps) {}
  /// Counts one more step, and returns whether the steps have stalled.
  bool stalls_with(double decrease);
  void reset() {
    least_ = std::numeric_limits<double>::infinity();
    steps_without_halving_ = 0;
  }

 private:
  std::int64_t most_steps_, steps_without_halving_ = 0;     // steps in a row without halving: limit, number
  double least_ = std::numeric_limits<double>::infinity();  // the decrease that must be halved next
};

/// Steps whose predicted decrease of the energy is less than the rounding of the energy. The whole step is
/// taken if it does not raise ‖r‖. Otherwise, if μ = 0, the slope decides by (7) of newton.hpp, the
/// approximate Wolfe conditions (W. W. Hager and H. Zhang, SIAM J. Optim. 16, 2005).
class RoundOffSteps {
 public:
  RoundOffSteps(const Newton::Parameters& parameters, Problem& problem, NearlyDefinite& nearly_definite,
                NegativeCurvature& curvature);

  /// Moves u by the whole step, or by the part of it that (7) finds.
  Step take(Iterate& iterate, const Direction& direction);
  /// If a damped step has not moved u, tries the undamped K, only once at each point. If K is positive
  /// definite or unsymmetric, its step is tried by take(). If K is nearly definite and all forces have a
  /// potential, u moves along negative curvature or, if there is none, by (7) along a step of K + σ M.
  Step fall_back(Iterate& iterate, double damping);
  /// Allows (7) of newton.hpp again after stalled steps. Called when a step judged by the merit has moved u.
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
  std::optional<std::size_t> fell_back_at_;  // Iterate::count() at the last use of fall_back
  std::vector<double> s_;                    // the step s that fall_back tries
};

}  // namespace netloft::newton
