// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/fitting/model.hpp"

#include <functional>
#include <limits>
#include <string>

namespace netloft {

/// The limits of a number.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

/// Minimise f_0(θ) with  low ≤ θ ≤ high  and  low_j ≤ f_j(θ) ≤ high_j,  j = 1, 2, …                 (1)
struct OptimumProblem {
  std::vector<double> start;        // θ at which the search begins
  std::vector<Bounds> parameters;   // limits of θ, which are finite; equal limits fix a parameter
  std::vector<Bounds> constraints;  // limits of f_1, f_2, …; equal limits are an equation
  bool maximise = false;            // whether f_0 is maximised instead
};

struct OptimumOptions {
  int evaluations = 60;       // limit of the number of predictions of the model
  double tolerance = 1e-4;    // largest remainder (3) of an optimum
  double feasibility = 1e-6;  // largest violation of a constraint, as a fraction of its size
};

/// A point of the search.
struct OptimumPoint {
  std::vector<double> parameters;
  std::vector<double> predictions;  // f(θ); empty: the model has no solution there
  double violation = 0;             // the largest violation, as a fraction of the size of the constraint
  bool is_accepted = false;         // whether the search continued from this point
  std::vector<std::vector<double>> slopes = {};                // ∂f/∂θ of an accepted point
  double remainder = std::numeric_limits<double>::infinity();  // (3) of an accepted point
};

/// The answer of optimise(). In scaled numbers (θ over its range, f_0 over its size at the start, f_j over
/// the size of its limit), a point is optimal if there are multipliers λ such that
///   r_i = ∂f_0/∂θ_i − Σ λ_j ∂f_j/∂θ_i                                                               (2)
/// is zero if θ_i is between its limits, not negative at the low limit and not positive at the high limit (W.
/// Karush 1939; H. W. Kuhn, A. W. Tucker 1951). λ_j is zero if f_j is between its limits, and has the sign of
/// a limit otherwise. The remainder is
///   max |r_i| over all r_i of the wrong sign                                                        (3)
/// which is the relative change of f_0 that the slopes still promise over the range of a parameter. λ makes
/// the sum of the squares of these r_i least. λ_j and r_i are the prices of limits: the change of the least
/// f_0 when the limit grows by one.
struct Optimum {
  bool converged = false;
  std::string reason;  // why the search ended, as a sentence
  // The answer: the last accepted point if the search converged, or if this point satisfies all constraints
  // and its scaled f_0 is above the least one by at most the allowed violation. Otherwise, it is the accepted
  // point with the least f_0 among those that satisfy all constraints; if none does, the one with the least
  // violation. `parameters` is empty if there is no answer.
  OptimumPoint best;
  std::vector<double> constraint_prices;  // λ_j, in units of f_0 per unit of f_j; 0: f_j is at no limit
  std::vector<double> parameter_prices;   // r_i, in units of f_0 per unit of θ_i; 0: θ_i is at no limit
  std::vector<OptimumPoint> history;      // all points in their order; slopes are left out
  bool is_feasible = false;               // whether the best point satisfies all constraints
};

/// Solves (1) by sequential quadratic programming in a trust region (J. Nocedal, S. J. Wright, Numerical
/// Optimization, 2006, ch. 18). A step d of the scaled parameters minimises
///   g·d + ½ d·B d + μ t,   low_j − t ≤ f_j + ∇f_j·d ≤ high_j + t,   |d_i| ≤ Δ,   t ≥ 0             (4)
/// B approximates the Hessian of f_0 − Σ λ_j f_j (damped BFGS), t is the violation that remains. A step is
/// accepted if f_0 + μ × violation (or f_0 alone, between points that satisfy all constraints) falls by at
/// least a small fraction of what (4) promises. Δ grows or shrinks according to the fraction that was
/// reached. If the model has no solution at the new point, the search stays at the old point and reduces Δ.
/// `on_point` is called after every prediction.
Optimum optimise(Model& model, const OptimumProblem& problem, const OptimumOptions& options = {},
                 const std::function<void(const OptimumPoint&)>& on_point = {});

}  // namespace netloft
