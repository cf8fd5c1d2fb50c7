// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/flow/momentum.hpp"

using netloft::flows::Momentum;

NETLOFT_PLUGIN("flow", "0.1.0", "Water that a gear changes") {
  auto& m = plugin.element<Momentum>(
      "momentum", "Water that the netting of a bag slows: the drag behind the mouth is the thrust of a disc");
  m.real("start", &Momentum::Parameters::start, "1", "initial guess of the induction factor",
         {.lo = 0, .hi = 1, .fallback = 0});
  m.global("induction", "1", "induction factor: fraction of the speed that the water loses in the bag",
           nullptr, Momentum::start);
  m.term<Momentum::Thrust, netloft::from_outside | netloft::needs_flow | netloft::reads_current>(
      "thrust", "thrust of the mouth, which the drag of the netting in its reach balances");
  m.output("mouth_area", "m2", "contribution of the bar to the area of the mouth across the current",
           [](auto&, auto&, auto& s) { return Momentum::area(s); });
  m.output("induction", "1", "fraction of the speed that the water loses in the bag",
           [](auto&, auto&, auto& s) { return s.x[2].x; });
  m.output(
      "beyond_disc", "1",
      "a bag that takes more than four tenths of the speed, for which the balance of momentum is an "
      "empirical curve",
      [](auto&, auto&, auto& s) { return s.x[2].x > 0.4 ? 1.0 : 0.0; }, netloft::OutputRole::doubt);
  m.output(
      "flows_back", "1",
      "a bag that takes more than all of the speed, so that water would flow back through its netting: its "
      "mouth "
      "is too small for the drag of the net, or is turned away from the current",
      [](auto&, auto&, auto& s) { return s.x[2].x > 1 || s.x[2].x < 0 ? 1.0 : 0.0; },
      netloft::OutputRole::doubt);
}
