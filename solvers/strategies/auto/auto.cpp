// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/auto.hpp"

#include "solvers/strategies/auto/race.hpp"
#include "solvers/strategies/auto/restarts.hpp"

namespace netloft::automatic {

void Auto::run(const Options& options, Search& search) {
  if (attempts_for(search, options).empty()) return search.decline("`without` leaves out every attempt");
  const double work = search.work_left();
  Race race(search, options);
  const Stage best = race.run();
  if (!best.is_stationary()) return;
  search.answer(best.u);
  if (best.has_converged()) restart(search, options, race.start(), best, work - search.work_left());
}

std::string Auto::explain(const Options& options, Search& search) {
  std::string text;
  for (const Attempt& attempt : attempts_for(search, options))
    text += std::string(attempt.name) + ": " + attempt.because + "\n";
  if (may_restart(search, options))
    text +=
        "restarts: " + std::to_string(options.restarts) + " from other shapes" +
        (options.everywhere ? ""
                            : " if a part of the first equilibrium bears load by compression or bending") +
        ": the gear may have other equilibria\n";
  return text;
}

}  // namespace netloft::automatic
