// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/strategies.hpp"

using namespace netloft::tension;

NETLOFT_PLUGIN("tension", "0.1.0", "Strategies whose unknowns are the tensions of ropes and twines") {
  Only::describe(plugin.strategy<Only>(
      "only", "Solves with members that bear tension only, and from that equilibrium the scene itself"));
  FromSoft::describe(plugin.strategy<FromSoft>(
      "stages", "Solves from soft to stiff with tensions as unknowns, and from the result the scene itself"));
}
