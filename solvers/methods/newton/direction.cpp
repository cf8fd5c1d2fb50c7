// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/direction.hpp"

#include <netloft/imbalance.hpp>

#include <algorithm>

namespace netloft::newton {

namespace {

const Direction kNoFactor{.failure = Outcome::linear_solve};
const Direction kLeadsUphill{.failure = Outcome::step_too_short};

}  // namespace

Direction Directions::find_first(Iterate& iterate, double damping) {
  Problem& problem = iterate.problem();
  if (problem.factorise(Matrix::exact, 0) == Factor::ok) {
    const Direction newton = solve(iterate, 0);
    if (problem.step_length(s_) <= 1 && iterate.slope({s_}) < 0) return newton;
  }
  return find(iterate, damping);
}

Direction Directions::find(Iterate& iterate, double damping) {
  return iterate.problem().symmetric() ? find_symmetric(iterate, damping)
                                       : find_unsymmetric(iterate, damping);
}

/// Finds a step for a symmetric K. Cholesky's factorisation shows whether K + μ M is positive definite.
Direction Directions::find_symmetric(Iterate& iterate, double damping) {
  const Factor factor = iterate.problem().factorise(Matrix::exact, damping);
  if (factor == Factor::ok) {
    tests_near_definite_ = true;
    return solve(iterate, damping);
  }
  if (factor != Factor::not_positive) return kNoFactor;
  if (const auto found = find_nearly_definite(iterate, damping)) return *found;
  return find_partly_convex(iterate, damping);
}

/// Tries K + σ M with a tiny σ. σ M changes Newton's step only in the few directions of negative curvature,
/// along which NegativeCurvature leaves the point; a convex part would change the step in all directions. If
/// K is far from definite, trying σ costs up to five factorisations. Therefore, after a failure or with μ ≥
/// kMatters, σ is not tried again until K + μ M has been positive definite.
std::optional<Direction> Directions::find_nearly_definite(Iterate& iterate, double damping) {
  if (!iterate.is_conservative() || !tests_near_definite_ || damping >= kMatters) {
    tests_near_definite_ = false;
    return {};
  }
  const auto sigma = nearly_definite_.factorise(iterate.problem());
  tests_near_definite_ = sigma.has_value();
  if (!sigma) return {};
  Direction direction = solve(iterate, *sigma, "nearly definite");
  direction.nearly_definite = true;
  return direction;
}

Direction Directions::find_partly_convex(Iterate& iterate, double damping) {
  Problem& problem = iterate.problem();
  if (problem.evaluate(problem.u(), Matrix::convex) != Evaluation::ok) return kNoFactor;
  if (factorise_partly_convex(problem, std::max(damping, range_.least)) != Factor::ok) return kNoFactor;
  return solve(iterate, damping, "convex part");
}

/// Factorises K + θ (K₊ − K) (newton.hpp (2)) first with half the last θ; doubles θ until the matrix is
/// positive definite. A θ below kMatters would add no stiffness that matters.
Factor Directions::factorise_partly_convex(Problem& problem, double shift) {
  for (convex_fraction_ = std::max(0.5 * convex_fraction_, kMatters); convex_fraction_ < 1;
       convex_fraction_ *= 2)
    if (const Factor factor = problem.factorise_between(convex_fraction_, shift);
        factor != Factor::not_positive)
      return factor;
  Factor factor = problem.factorise(Matrix::convex, shift);
  while (factor == Factor::not_positive && shift < range_.most)  // possible only by rounding
    factor = problem.factorise(Matrix::convex, shift = range_.raised(shift));
  return factor;
}

/// Raises μ until s leads downhill. A successful factorisation is not enough, because it does not show
/// whether an unsymmetric matrix is definite.
Direction Directions::find_unsymmetric(Iterate& iterate, double damping) {
  for (const char* note = "";; note = "more damping", damping = range_.raised(damping)) {
    const Factor factor = iterate.problem().factorise(Matrix::exact, damping);
    if (factor == Factor::ok) {
      const Direction direction = solve(iterate, damping, note);
      if (iterate.slope({s_}) < 0) return direction;
    }
    if (damping >= range_.most || factor == Factor::failed)
      return factor == Factor::ok ? kLeadsUphill : kNoFactor;
  }
}

Direction Directions::solve(Iterate& iterate, double damping, const char* note) {
  iterate.solve(s_);
  return {.s = s_, .damping = damping, .note = note};
}

}  // namespace netloft::newton
