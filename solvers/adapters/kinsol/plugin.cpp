// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/adapters/kinsol/kinsol.hpp"

using netloft::kinsol::Kinsol;

NETLOFT_PLUGIN("kinsol", "0.1.0", "Newton's method of SUNDIALS' KINSOL") {
  auto& kinsol =
      plugin.solver<Kinsol>("kinsol", "KINSOL's Newton, with our factorisations as its linear solver");
  kinsol.choice("strategy", &Kinsol::Parameters::strategy,
                "linesearch: shortens steps until the residual falls; none: takes them whole",
                {"linesearch", "none"});
  kinsol.real("damping", &Kinsol::Parameters::damping, "1",
              "factor on the linear stiffness that is added to the step's matrix",
              {.lo = 0, .hi = 64, .fallback = 0});
  kinsol.real("longest_step", &Kinsol::Parameters::longest_step, "1",
              "longest step, root mean square over the unknowns, in lengths of the largest element",
              {.lo = 1e-6, .hi = 1e12, .fallback = 1000});
  kinsol.real("shortest_step", &Kinsol::Parameters::shortest_step, "1",
              "shortest step that is tried, relative to the unknown that changes most",
              {.lo = 1e-16, .hi = 0.1, .fallback = 1e-12});
}
