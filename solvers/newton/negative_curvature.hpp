// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "solvers/newton/iterate.hpp"
#include "solvers/newton/least_curvature.hpp"

namespace netloft::newton {

/// μ times a factor, between its ends.
inline double raised(double damping, double factor, const Newton::Parameters& p) {
  return std::clamp(damping * factor, p.least_damping, p.most_damping);
}
/// An unsymmetric K needs it down to its rounding (`end`): soft parts of a gear want less than stiff ones, by
/// the ratio of their stiffnesses.
inline double lowered(double damping, double end, const Newton::Parameters& p) {
  return damping < p.factor * end ? 0 : damping / p.factor;
}

/// The way off a saddle: where K + σ M is positive definite with a small σ (K is nearly definite) and K is
/// not, along the direction of least curvature, (6) of Newton.
class NegativeCurvature {
 public:
  /// Memory for the directions is reserved, and touched by the first of them.
  NegativeCurvature(const Newton::Parameters& parameters, const Problem& problem);

  /// σ such that K + σ M is positive definite, and factorised; none where K is not nearly definite.
  std::optional<double> factorise_nearly_definite(Problem& problem);
  /// By the factor of K + σ M: v along which K curves downwards most, if it does along any. Nothing moves.
  /// The vector is valid until the next search.
  std::optional<std::span<const double>> find_direction(Problem& problem, double sigma);
  /// Moves along ±v to where the energy no longer falls; false if it never does.
  bool leave_along(std::span<const double> v, Iterate& iterate);

 private:
  const Newton::Parameters& p_;
  double sigma_;  // of the last K that was nearly definite
  LeastCurvature curvature_;
  std::vector<double> downhill_;  // ±v, one element long
};

}  // namespace netloft::newton
