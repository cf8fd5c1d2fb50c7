// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/snes/snes.hpp"

using netloft::snes::Snes;

NETLOFT_PLUGIN("snes", "0.1.0", "Newton's methods of PETSc's SNES") {
  auto& snes = plugin.solver<Snes>("snes", "SNES' Newton, with our factorisations as its linear solver");
  snes.choice("strategy", &Snes::Parameters::strategy,
              "linesearch or trust-region: shorten steps until the residual falls; none: takes them whole",
              {"linesearch", "trust-region", "none"});
  snes.real("damping", &Snes::Parameters::damping, "1",
            "factor on the linear stiffness that is added to the step's matrix",
            {.lo = 0, .hi = 64, .fallback = 0});
}
