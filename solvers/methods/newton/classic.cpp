// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/methods.hpp"

namespace netloft::newton {

Outcome solve_classic(Problem& problem) {
  const std::size_t n = problem.size();
  std::vector<double> residual(n), step(n);
  double energy = 0;
  for (;;) {
    if (problem.evaluate(problem.u(), energy, residual, Matrix::exact) != Evaluation::ok)
      return Outcome::left_domain;
    if (!problem.progress(problem.u(), energy, residual)) return Outcome::stopped;
    if (problem.factorise_indefinite(Matrix::exact, 0) != Factor::ok) return Outcome::linear_solve;
    problem.solve(residual, step);
    for (std::size_t i = 0; i < n; ++i) problem.u()[i] -= step[i];  // (1)
  }
}

}  // namespace netloft::newton
