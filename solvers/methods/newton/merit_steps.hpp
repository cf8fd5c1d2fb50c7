// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "solvers/methods/newton/direction.hpp"
#include "solvers/methods/newton/iterate.hpp"
#include "solvers/methods/newton/newton.hpp"
#include "solvers/methods/newton/step.hpp"

namespace netloft::newton {

/// The vector a of the curved path u + t s + ½ t² a, (8) of newton.hpp. On this path, stiff members keep
/// their length to second order ("geodesic acceleration": M. K. Transtrum and J. P. Sethna, arXiv:1201.5885,
/// 2012).
class CurvedStep {
 public:
  /// Reserves memory for `size` unknowns. It is not filled before find().
  explicit CurvedStep(std::size_t size) {
    minus_second_derivative_.reserve(size);
    a_.reserve(size);
  }
  /// Computes a with the last factor, from differences of r between u − t s, u and u + t s. Returns an empty
  /// vector if forces are undefined at one of these points.
  std::span<const double> find(Iterate& iterate, std::span<const double> s, double t);

 private:
  std::vector<double> minus_second_derivative_, a_;
};

/// Steps that the merit m judges: the whole step (5), the line search (4) and the curved path (8) of
/// newton.hpp. (4) is the strong Wolfe condition (Nocedal and Wright 2006, ch. 3) without sufficient
/// decrease. (5) is a relaxed test that lets an iterate cross the kinks between slack and taut, as in the
/// watchdog technique (Chamberlain et al. 1982, Math. Programming Study 16), but without a return to an
/// earlier point. The sum of all decreases of m shows whether m is as low as it has ever been: after a step
/// that raised m, no other step may raise it until the sum has recovered. Otherwise, netting on a bed with
/// friction would circle its equilibrium. (5) excludes steps longer than an element, because their −r·s is so
/// large that (5) would allow any rise. (8) is tried if all forces have a potential, K is symmetric and (4)
/// rejects t = 1.
class MeritSteps {
 public:
  MeritSteps(const Newton::Parameters& parameters, std::size_t size) : p_(parameters), curved_(size) {}

  /// Moves u along s: by the whole step if (5) allows it, otherwise by (4), or by (8) if the step by (4) is
  /// too short and (8) gains more.
  Step take(Iterate& iterate, const Direction& direction);
  /// Adds the decrease of m by a step, or by a move along negative curvature, to the sum.
  void add_gain(double gain) {
    gained_ += gain;
    most_gained_ = std::max(most_gained_, gained_);
  }

 private:
  std::optional<Sample> try_whole_step(Iterate& iterate, const Path& path) const;

  const Newton::Parameters& p_;
  CurvedStep curved_;
  double gained_ = 0, most_gained_ = 0;  // sum of all decreases of m, and its largest value so far
};

}  // namespace netloft::newton
