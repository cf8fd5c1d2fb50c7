// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/ts/ts.hpp"

using netloft::ts::Ts;

NETLOFT_PLUGIN("ts", "0.1.0", "The generalised-alpha method of PETSc's TS") {
  auto& ts = plugin.integrator<Ts>("ts", "Chung and Hulbert's scheme as PETSc has it, TSALPHA2");
  ts.real("spectral_radius", &Ts::Parameters::spectral_radius, "1",
          "factor per step on motions far too fast for it: 1 keeps them, 0 removes them",
          {.lo = 0, .hi = 1, .fallback = 0});
}
