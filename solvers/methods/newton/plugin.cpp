// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/methods.hpp"

using netloft::newton::Newton;

netloft::Outcome Newton::solve(const Parameters& parameters, Problem& problem) {
  return parameters.method == 0 ? solve_globalised(parameters, problem) : solve_classic(problem);
}

NETLOFT_PLUGIN("newton", "0.1.0", "Newton's method, classic or globalised") {
  auto& newton = plugin.solver<Newton>(
      "newton", "Newton's method with a line search on the energy, or the method of the paper");
  newton.choice(
      "method", &Newton::Parameters::method,
      "globalised: damped in the metric of the linear stiffness; classic: the paper's method, undamped",
      {"globalised", "classic"});
  newton.real("damping", &Newton::Parameters::damping, "1",
              "fraction of the linear stiffness that is first added to the matrix of a step",
              {.lo = 0, .hi = 64, .fallback = 0.1});
  newton.real("least_damping", &Newton::Parameters::least_damping, "1",
              "damping below this is set to zero, where the tangent is symmetric",
              {.lo = 1e-15, .hi = 1e-3, .fallback = 1e-7});
  newton.real("most_damping", &Newton::Parameters::most_damping, "1",
              "damping at which the method gives up; with 1, a convex energy cannot rise, but no matrix can "
              "be factorised in time steps in which a rope snaps taut",
              {.lo = 1, .hi = 1e6, .fallback = 64});
  newton.real("factor", &Newton::Parameters::factor, "1",
              "damping is divided by this after a step of more than half the length or at round-off, and "
              "multiplied by it where no step is found",
              {.lo = 1.1, .hi = 1e3, .fallback = 8});
  newton.real("flatness", &Newton::Parameters::flatness, "1",
              "fraction of the slope that may be left where a search along a line ends: with 0.1, a cod-end "
              "under follower pressure ran away",
              {.lo = 1e-3, .hi = 1, .fallback = 0.2});
  newton.real("uphill", &Newton::Parameters::uphill, "1",
              "multiple of the slope by which a whole step may raise the merit function, if the merit is as "
              "low as it has ever been; 0: none",
              {.lo = 0, .hi = 100, .fallback = 2});
  newton.real("margin", &Newton::Parameters::margin, "1",
              "least distance of a new point from either end of the bracket of a line search, as a fraction "
              "of the bracket; a step away from a saddle moves a node by at most 1/margin elements: with "
              "0.2, a saddle at round-off was not left",
              {.lo = 1e-3, .hi = 0.5, .fallback = 0.1});
  newton.integer("refinements", &Newton::Parameters::refinements,
                 "number of points at which a line search tries to improve on a point that is good enough", 0,
                 100, 4);
}
