// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/ptc/methods.hpp"

using netloft::ptc::PseudoTransient;

netloft::Outcome PseudoTransient::solve(const Parameters& parameters, Problem& problem) {
  return parameters.method == 0 ? solve_linearly_implicitly(parameters, problem)
                                : solve_implicitly(parameters, problem);
}

NETLOFT_PLUGIN("ptc", "0.1.0", "pseudo-transient continuation") {
  using P = PseudoTransient::Parameters;
  auto& ptc = plugin.solver<PseudoTransient>("ptc",
                                             "pseudo-transient continuation in the metric of the linear "
                                             "stiffness, with switched evolution relaxation");
  ptc.choice("method", &P::method,
             "linearly-implicit: one linear solve a step; implicit: each step solved by Newton's method",
             {"linearly-implicit", "implicit"});
  ptc.real("step", &P::step, "1",
           "linearly-implicit: first step of the pseudo-time, over what the linear stiffness needs to relax",
           {.lo = 1e-6, .hi = 1e12, .fallback = 100});
  ptc.real("growth", &P::growth, "1", "linearly-implicit: most by which a step may exceed the last",
           {.lo = 1, .hi = 1e6, .fallback = 10});
  ptc.real("shrink", &P::shrink, "1",
           "linearly-implicit: least part of the last step that a step may be when the residual has grown",
           {.lo = 0, .hi = 1, .fallback = 0.7});
  ptc.real("reach", &P::reach, "1",
           "linearly-implicit: farthest move of a node in one step, over the largest element; a longer step "
           "is taken back",
           {.lo = 1e-3, .hi = 1e12, .fallback = 10});
  ptc.integer("corrections", &P::corrections,
              "implicit: corrections after which a step is taken back; half as many allow a longer one", 2,
              1000, 8);
  ptc.real("solved", &P::solved, "1", "implicit: part of a step that its last correction may be",
           {.lo = 1e-12, .hi = 0.5, .fallback = 0.01});
}
