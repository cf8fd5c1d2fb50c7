// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/solver.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

/// Newton's method with the positive part of the tangent, damped by the linear stiffness:
///   (K₊ + μ M) s = −r                                                     (1)
///   u ← u + t s,  t = 1, ½, ¼ … until E(u + t s) ≤ E(u) + ε|E|            (2)
///                                 and s·r(u + t s) ≤ −η s·r(u)            (3)
/// r [N] residual, the gradient of the energy E [J]; K₊ positive part of the tangent, M linear stiffness. A
/// step is accepted if E does not increase beyond rounding, ε (2), and if it passes the minimum along s by no
/// more than η (3). (3) decides when rounding hides the change of E (Hager, Zhang, SIAM J. Optim. 16, 2005).
struct MySolver {
  struct Parameters {
    double damping = 0, overshoot = 0;  // damping μ, limit η
  };
  static constexpr double kRounding = 1e-14;  // rounding ε

  static netloft::Outcome solve(const Parameters& p, netloft::Problem& problem) {
    using namespace netloft;
    std::vector<double> r(problem.size()), s(problem.size());
    double energy = 0;
    for (;;) {
      if (problem.evaluate(problem.u(), energy, r, Matrix::convex) != Evaluation::ok)
        return Outcome::left_domain;
      if (!problem.progress(problem.u(), energy, r)) return Outcome::stopped;
      if (problem.factorise(Matrix::convex, p.damping) != Factor::ok) return Outcome::linear_solve;
      problem.solve(r, s);  // (1)
      for (double& component : s) component = -component;
      if (!descend(p, problem, energy, r, s)) return Outcome::step_too_short;
    }
  }

  /// Moves u by a step that (2) and (3) accept. Returns whether there is such a step.
  static bool descend(const Parameters& p, netloft::Problem& problem, double energy, std::vector<double>& r,
                      const std::vector<double>& s) {
    std::vector<double> u(problem.size());
    const double slope = dot(r, s);
    double there = 0;
    for (double t = 1; t > 1e-12; t /= 2) {
      for (std::size_t i = 0; i < u.size(); ++i) u[i] = problem.u()[i] + t * s[i];
      if (problem.evaluate(u, there, r) != netloft::Evaluation::ok) continue;
      if (there > energy + kRounding * std::abs(energy)) continue;  // (2)
      if (dot(r, s) > -p.overshoot * slope) continue;               // (3)
      std::copy(u.begin(), u.end(), problem.u().begin());
      return true;
    }
    return false;
  }

  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }
};

NETLOFT_PLUGIN("my_solver", "0.1", "A solver to begin with") {
  auto& s = plugin.solver<MySolver>("my_solver", "Newton's method, damped by the linear stiffness");
  s.needs(NETLOFT_CONSERVATIVE);
  s.real("damping", &MySolver::Parameters::damping, "1",
         "fraction of the linear stiffness that is added to the matrix",
         {.lo = 0, .hi = 64, .fallback = 0.1});
  s.real("overshoot", &MySolver::Parameters::overshoot, "1",
         "largest uphill slope after a step, as a fraction of the slope before it",
         {.lo = 0, .hi = 1, .fallback = 0.5});
}
