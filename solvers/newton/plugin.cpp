// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/newton/methods.hpp"

using netloft::newton::Newton;

netloft::Outcome Newton::solve(const Parameters& parameters, Problem& problem) {
  return parameters.method == 0 ? solve_globalised(parameters, problem) : solve_classic(problem);
}

NETLOFT_PLUGIN("newton", "0.1.0", "Newton's method, as published and globalised") {
  auto& newton =
      plugin.solver<Newton>("newton", "Newton's method with a line search on the energy, or the paper's");
  newton.choice("method", &Newton::Parameters::method,
                "globalised: damped in the metric of the linear stiffness; classic: the paper's, undamped",
                {"globalised", "classic"});
  newton.real("damping", &Newton::Parameters::damping, "1",
              "first share of the linear stiffness in the step's matrix",
              {.lo = 0, .hi = 64, .fallback = 0.1});
  newton.real("decrease", &Newton::Parameters::decrease, "1",
              "share of the slope by which a step must lower the energy",
              {.lo = 1e-12, .hi = 0.5, .fallback = 1e-4});
  newton.real("flatness", &Newton::Parameters::flatness, "1",
              "share of the slope that may be left where the search along a step ends",
              {.lo = 1e-3, .hi = 1, .fallback = 0.2});
  newton.real("uphill", &Newton::Parameters::uphill, "1",
              "multiple of the slope by which every other whole step may raise the energy; 0: none",
              {.lo = 0, .hi = 100, .fallback = 2});
  newton.real("shortest_step", &Newton::Parameters::shortest_step, "1",
              "shortest part of a step that is tried", {.lo = 1e-16, .hi = 0.5, .fallback = 1e-4});
}
