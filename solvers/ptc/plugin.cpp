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
           "first step of the pseudo-time, over what the linear stiffness needs to relax",
           {.lo = 1e-6, .hi = 1e12, .fallback = 100});
  ptc.real("growth", &P::growth, "1",
           "most by which a step may exceed the last; one that is taken back is tried again so much shorter",
           {.lo = 1, .hi = 1e6, .fallback = 4});
  ptc.real("reach", &P::reach, "1",
           "farthest move of a node in one step, over the largest element; a longer step is taken back",
           {.lo = 1e-3, .hi = 1e12, .fallback = 10});
  ptc.real("solved", &P::solved, "1",
           "implicit: an implicit step is solved when a correction is at most this part of it",
           {.lo = 1e-12, .hi = 1, .fallback = 0.1});
  ptc.integer("corrections", &P::corrections,
              "implicit: corrections after which a step is given up; after half of them the next is longer",
              1, 1000, 8);
}
