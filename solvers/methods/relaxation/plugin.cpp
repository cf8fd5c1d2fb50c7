// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/relaxation/relaxation.hpp"

using netloft::relaxation::Relaxation;

NETLOFT_PLUGIN("relaxation", "0.1.0", "dynamic relaxation") {
  using P = Relaxation::Parameters;
  auto& relaxation = plugin.solver<Relaxation>(
      "relaxation", "dynamic relaxation with kinetic damping and fitted masses; factorises nothing");
  relaxation.integer("steps", &P::steps,
                     "number of steps of the motion in one iteration, after which progress is judged", 1,
                     1000000, 1000);
}
