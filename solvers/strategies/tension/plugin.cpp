// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/strategies.hpp"

using namespace netloft::tension;

NETLOFT_PLUGIN("tension", "0.1.0", "Strategies whose unknowns are the tensions of ropes and twines") {
  Only::describe(plugin.strategy<Only>(
      "only",
      "Solves the scene with members that bear tension only, then the scene itself from that equilibrium"));
  FromSoft::describe(plugin.strategy<FromSoft>(
      "stages",
      "Solves with growing stiffness and tensions as unknowns, then the scene itself from the result"));
}
