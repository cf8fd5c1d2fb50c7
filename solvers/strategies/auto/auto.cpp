// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/auto.hpp"

#include "solvers/strategies/auto/race.hpp"
#include "solvers/strategies/auto/restarts.hpp"

namespace netloft::automatic {

void Auto::run(const Options& options, Study& study) {
  if (attempts_for(study, options).empty()) return study.decline("every attempt is left out");
  const Stage best = Race(study, options).run();
  if (!best.is_stationary()) return;
  study.answer(best.u);
  if (best.has_converged()) restart(study, options, best);
}

std::string Auto::explain(const Options& options, Study& study) {
  std::string text;
  for (const Attempt& attempt : attempts_for(study, options))
    text += std::string(attempt.name) + ": " + attempt.because + "\n";
  if (may_restart(study, options))
    text += "restarts: " + std::to_string(options.restarts) + " from elsewhere after the first equilibrium" +
            (options.everywhere ? "" : ", if it bears a load by compression") +
            ": there may be other shapes\n";
  return text;
}

}  // namespace netloft::automatic
