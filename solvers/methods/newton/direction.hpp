// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "solvers/methods/newton/damping.hpp"
#include "solvers/methods/newton/iterate.hpp"
#include "solvers/methods/newton/nearly_definite.hpp"

namespace netloft::newton {

/// A step s by (2) of newton.hpp and the damping of its matrix, or the reason why there is no step.
struct Direction {
  std::span<const double> s = {};
  double damping = 0;            // requested μ; with a convex part, a larger μ may have been used
  bool nearly_definite = false;  // K is not positive definite, but K + μ M is, with a tiny μ
  const char* note = "";
  std::optional<Outcome> failure = {};
  explicit operator bool() const { return !failure; }
};

/// Finds steps s along which the merit falls, by (2) of newton.hpp: (K + θ (K₊ − K) + μ M) s = −r. With θ = 1
/// and μ = 1 a step cannot raise a convex energy (Levenberg 1944, in the metric of the linear stiffness).
class Directions {
 public:
  Directions(const DampingRange& range, const Problem& problem, NearlyDefinite& nearly_definite)
      : range_(range), nearly_definite_(nearly_definite), s_(problem.size()) {}

  /// Returns Newton's own step (θ = μ = 0) if it leads downhill and moves no node by more than the length of
  /// an element, as is usual near an equilibrium. Otherwise it returns the step of `find`.
  Direction find_first(Iterate& iterate, double damping);
  /// Returns a step with the damping μ or more. It fails if no matrix could be factorised, or no s leads
  /// downhill. The vector s is valid until the next search.
  Direction find(Iterate& iterate, double damping);

 private:
  Direction find_symmetric(Iterate& iterate, double damping);
  std::optional<Direction> find_nearly_definite(Iterate& iterate, double damping);
  Direction find_partly_convex(Iterate& iterate, double damping);
  Direction find_unsymmetric(Iterate& iterate, double damping);
  Factor factorise_partly_convex(Problem& problem, double shift);
  Direction solve(Iterate& iterate, double damping, const char* note = "");

  const DampingRange& range_;
  NearlyDefinite& nearly_definite_;
  std::vector<double> s_;
  double convex_fraction_ = 1;       // last fraction θ of the convex part
  bool tests_near_definite_ = true;  // the last K + μ M was positive definite, or the last K nearly so
};

}  // namespace netloft::newton
