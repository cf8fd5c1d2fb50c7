// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/scenes.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/session.hpp"

#include <cstdio>

namespace netloft::program {

int plan_command(const MethodOptions& options) {
  Session session(options);
  if (const int code = session.open(); code != kDone) return code;
  runs::PreparedScene& scene = session.scene();
  results::PlanExtras extras = plan_extras(scene);
  const runs::MemoryForecast memory = runs::foresee_memory(scene);
  extras.memory = memory.total();
  extras.factor_memory = memory.factor;
  extras.stability_memory = memory.stability;
  std::puts(options.json ? results::plan_json(scene.loaded().scene, scene.plan(), extras).c_str()
                         : (results::plan_text(scene.plan(), extras) +
                            memory_text(memory, runs::memory_within_reach()))
                               .c_str());
  return kDone;
}

}  // namespace netloft::program
