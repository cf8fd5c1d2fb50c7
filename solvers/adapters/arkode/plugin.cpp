// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/adapters/arkode/arkode.hpp"

using netloft::arkode::Arkode;

NETLOFT_PLUGIN("arkode", "0.1.0", "Runge-Kutta methods of SUNDIALS' ARKODE") {
  auto& arkode = plugin.integrator<Arkode>(
      "arkode", "implicit Runge-Kutta methods of order 2 to 4, with embedded estimates of their errors");
  arkode.choice("method", &Arkode::Parameters::method,
                "esdirk3: Kennedy and Carpenter's method of order 3; tr-bdf2: trapezoidal rule and backward "
                "difference, of order 2; kvaerno4: of order 4",
                {"esdirk3", "tr-bdf2", "kvaerno4"});
}
