// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "solvers/methods/newton/iterate.hpp"
#include "solvers/methods/newton/least_curvature.hpp"

namespace netloft::newton {

/// Leaves a saddle along the direction of the most negative curvature, (6) of newton.hpp (J. J. Moré and D.
/// C. Sorensen, Math. Programming 16, 1979), by at most 1/`margin` lengths of an element. All forces must
/// have a potential.
class NegativeCurvature {
 public:
  /// Reserves memory for the directions. It is not filled before the first search.
  NegativeCurvature(const Newton::Parameters& parameters, const Problem& problem);

  /// Returns the direction v of the most negative curvature of K, if there is any. The last factor must be
  /// that of K + σ M. The vector is valid until the next search.
  std::optional<std::span<const double>> find_direction(Problem& problem, double sigma);
  /// Moves along v or −v as long as the energy falls. Returns false if it does not fall at all.
  bool leave_along(std::span<const double> v, Iterate& iterate);

 private:
  const Newton::Parameters& p_;
  LeastCurvature curvature_;
  std::vector<double> downhill_;  // ±v, one element long
};

}  // namespace netloft::newton
