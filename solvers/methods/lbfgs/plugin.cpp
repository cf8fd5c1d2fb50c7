// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/lbfgs/lbfgs.hpp"

using netloft::lbfgs::Lbfgs;

NETLOFT_PLUGIN("lbfgs", "0.1.0", "limited-memory BFGS") {
  using P = Lbfgs::Parameters;
  auto& lbfgs = plugin.solver<Lbfgs>(
      "lbfgs",
      "limited-memory BFGS on the energy, preconditioned by the linear stiffness; one factorisation");
  lbfgs.needs(NETLOFT_CONSERVATIVE);
  lbfgs.integer("memory", &P::memory, "number of remembered pairs of steps and residual changes", 1, 1000, 8);
  lbfgs.choice("preconditioner", &P::preconditioner,
               "stiffness: the linear stiffness, factorised once; diagonal: its row sums; none",
               {"stiffness", "diagonal", "none"});
  lbfgs.integer("steps", &P::steps, "number of steps in one iteration, after which progress is judged", 1,
                1000000, 10);
  lbfgs.real("decrease", &P::decrease, "1", "fraction of the slope by which a step must lower the energy",
             {.lo = 1e-12, .hi = 0.49, .fallback = 1e-4});
  lbfgs.real("curvature", &P::curvature, "1", "fraction of the slope that may be left at the end of a step",
             {.lo = 0.5, .hi = 0.999, .fallback = 0.9});
}
