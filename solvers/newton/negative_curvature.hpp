// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <vector>

#include "solvers/newton/iterate.hpp"
#include "solvers/newton/least_curvature.hpp"

namespace netloft::newton {

/// The way off a saddle: where K + σ M is positive definite with a small σ (K is nearly definite) and K is
/// not, along the direction of least curvature, (6) of Newton.
class NegativeCurvature {
 public:
  /// Memory for the directions is reserved, and touched by the first of them.
  explicit NegativeCurvature(const Problem& problem);

  /// σ such that K + σ M is positive definite, and factorised; none where K is not nearly definite.
  std::optional<double> factorise_nearly_definite(Problem& problem);
  /// By the factor of K + σ M: whether K curves downwards anywhere. Nothing moves.
  bool find_direction(Problem& problem, double sigma);
  /// Moves along the direction found to where the energy no longer falls; false if it never does.
  bool leave(Iterate& iterate);

 private:
  double sigma_;  // the last that did
  LeastCurvature curvature_;
  std::vector<double> v_;
};

}  // namespace netloft::newton
