// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/ptc/ptc.hpp"

using netloft::ptc::PseudoTransient;

NETLOFT_PLUGIN("ptc", "0.2.0", "pseudo-transient continuation") {
  using P = PseudoTransient::Parameters;
  auto& ptc = plugin.solver<PseudoTransient>(
      "ptc", "pseudo-transient continuation in the metric of the linear stiffness, by implicit Euler steps");
  ptc.integer("corrections", &P::corrections,
              "number of corrections after which a step is repeated with half its length; after half as "
              "many, the next step is twice as long",
              2, 1000, 8);
  ptc.real("solved", &P::solved, "1",
           "a step has converged when its last correction is shorter than this fraction of the step",
           {.lo = 1e-12, .hi = 0.5, .fallback = 0.01});
}
