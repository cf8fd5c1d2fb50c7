// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/scenes.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/session.hpp"
#include "io/runs/equilibrium.hpp"

namespace netloft::program {

int plan_command(const MethodOptions& options) {
  Session session(options);
  if (const int code = session.open(); code != kDone) return code;
  runs::PreparedScene& scene = session.scene();
  if (const auto why_not = runs::why_unfit(scene)) throw UsageError{*why_not};
  results::PlanExtras extras = plan_extras(scene);
  const runs::MemoryForecast memory = runs::foresee_memory(scene);
  extras.memory = memory.total();
  extras.factor_memory = memory.factor;
  extras.stability_memory = memory.stability;
  print_line(options.json ? results::plan_json(scene.loaded().scene, scene.plan(), extras)
                          : (results::plan_text(scene.plan(), extras) +
                             memory_text(memory, runs::memory_within_reach())));
  return kDone;
}

}  // namespace netloft::program
