// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/strategies.hpp"

using namespace netloft::tension;

NETLOFT_PLUGIN("tension", "0.1.0", "Strategies whose unknowns are the tensions of ropes and twines") {
  Only::describe(plugin.strategy<Only>(
      "only", "First the equilibrium of members that bear tension only, then from there the scene itself"));
  FromSoft::describe(plugin.strategy<FromSoft>(
      "stages",
      "From soft to stiff with tensions as unknowns of their own, then from there the scene itself"));
}
