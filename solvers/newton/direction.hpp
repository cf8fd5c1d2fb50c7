// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "solvers/newton/iterate.hpp"
#include "solvers/newton/negative_curvature.hpp"
#include "solvers/newton/newton.hpp"

namespace netloft::newton {

/// A step s of (2) of Newton, and the matrix it belongs to.
struct Direction {
  std::span<const double> s;
  double damping = 0;            // μ, or as much as was asked for where convex parts have taken its place
  bool nearly_definite = false;  // K is not positive definite, and K + μ M is, with a μ next to nothing
  const char* note = "";
};

/// Finds steps s along which the merit falls.
class Directions {
 public:
  Directions(const Newton::Parameters& parameters, const Problem& problem, NegativeCurvature& curvature);

  /// Newton's own step, if it leads downhill and moves no node by more than the length of an element.
  std::optional<Direction> find_short_undamped(Iterate& iterate);
  /// A step with at least the damping μ. None: no matrix could be factorised, or with none s leads downhill.
  std::optional<Direction> find(Iterate& iterate, double damping);
  /// There was a factor, but no step of it led downhill.
  bool led_uphill() const { return led_uphill_; }

 private:
  std::optional<Direction> find_symmetric(Iterate& iterate, double damping);
  std::optional<Direction> find_nearly_definite(Iterate& iterate, double damping);
  std::optional<Direction> find_partly_convex(Iterate& iterate, double damping);
  std::optional<Direction> find_unsymmetric(Iterate& iterate, double damping);
  Factor factorise_partly_convex(Problem& problem, double shift);
  Direction solve(Iterate& iterate, double damping, const char* note = "");

  const Newton::Parameters& p_;
  NegativeCurvature& curvature_;
  std::vector<double> s_;
  bool led_uphill_ = false;
  double convex_share_ = 1;          // θ of the last time
  bool tests_near_definite_ = true;  // K + μ M was positive definite the last time, or K nearly so
};

}  // namespace netloft::newton
