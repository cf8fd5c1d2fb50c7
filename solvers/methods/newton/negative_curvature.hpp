// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "solvers/methods/newton/iterate.hpp"
#include "solvers/methods/newton/least_curvature.hpp"

namespace netloft::newton {

/// The way off a saddle, along the direction in which K curves downwards most: (6) of Newton.
class NegativeCurvature {
 public:
  /// Memory for the directions is reserved, and touched by the first of them.
  NegativeCurvature(const Newton::Parameters& parameters, const Problem& problem);

  /// By the factor of K + σ M: v along which K curves downwards most, if it does along any. Nothing moves.
  /// The vector is valid until the next search.
  std::optional<std::span<const double>> find_direction(Problem& problem, double sigma);
  /// Moves along ±v to where the energy no longer falls; false if it never does.
  bool leave_along(std::span<const double> v, Iterate& iterate);

 private:
  const Newton::Parameters& p_;
  LeastCurvature curvature_;
  std::vector<double> downhill_;  // ±v, one element long
};

}  // namespace netloft::newton
