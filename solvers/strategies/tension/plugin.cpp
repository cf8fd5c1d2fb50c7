// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/tension/strategies.hpp"

using namespace netloft::tension;

NETLOFT_PLUGIN("tension", "0.1.0", "Strategies whose unknowns are the tensions of ropes and twines") {
  Only::describe(plugin.strategy<Only>(
      "only", "First where everything comes to rest if it bears tension only, then as it is from there"));
  FromSoft::describe(plugin.strategy<FromSoft>(
      "stages", "From soft to stiff with tensions as unknowns of their own, then as it is from there"));
}
