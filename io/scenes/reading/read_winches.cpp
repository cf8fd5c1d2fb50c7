// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/read_winches.hpp"

#include "framework/search/settings.hpp"

#include <algorithm>

namespace netloft::scenes {

namespace {

/// The rope of the plan that has a given tension or a winch program; nullptr if there is none. All warps are
/// one rope in the plan.
const gears::Rope* find_warp(const gears::NetPlan& plan) {
  const auto is_run = [](const gears::Rope& rope) { return rope.tension || !rope.winch.empty(); };
  const auto warp = std::ranges::find_if(plan.ropes, is_run);
  return warp == plan.ropes.end() ? nullptr : &*warp;
}

bool has_lengths(const LoadedScene& out) {
  return std::ranges::all_of(out.scene.settings,
                             [&](const Setting& one) { return amount_of(out.scene, one) > 0; });
}

bool has_table(const Part& part, Registry& registry, const std::string& name) {
  return std::ranges::any_of(registry.element(part.type).parameters, [&](const netloft_parameter& p) {
    return p.kind == NETLOFT_TABLE && name == p.name;
  });
}

/// The part that is the rope with this name; nullptr if its element type was rejected.
Part* find_part(Scene& scene, const std::string& name) {
  const auto part =
      std::ranges::find_if(scene.parts, [&](const Part& one) { return one.name == name && !one.companion; });
  return part == scene.parts.end() || part->type.empty() ? nullptr : &*part;
}

}  // namespace

void ready_winches(const gears::NetPlan& plan, Registry& registry, LoadedScene& out,
                   formats::Diagnostics& diagnostics) {
  const gears::Rope* warp = find_warp(plan);
  if (!warp || diagnostics.errors() > 0) return;
  if (out.analysis.settles && warp->tension)
    diagnostics.error(warp->tension_place,
                      "ship.warp.tension needs a solver that finds equilibria, but \"" + out.analysis.solver +
                          "\" is an integrator",
                      "name another solver in [analysis]");
  if (!has_lengths(out))
    diagnostics.error(warp->tension_place,
                      "ship.warp.tension needs ropes whose length can change, but the elements of "
                      "elements.ropes.type have no length",
                      "choose an element type with a rest length, such as rope/bar");
  if (out.analysis.kind != AnalysisKind::dynamics) return out.scene.winches.clear();
  for (const Winch& winch : out.scene.winches) {
    Part* part = find_part(out.scene, winch.part);
    if (!part) continue;
    if (!has_table(*part, registry, winch.parameter)) {
      diagnostics.error(warp->winch.empty() ? warp->tension_place : warp->winch_place,
                        "a winch changes the length of its rope, and that of " + part->type + " is fixed",
                        "elements.ropes.type = \"rope/bar\"");
      return;
    }
    part->parameters[winch.parameter] = Samples{{0, 1}, {1, 1}};  // the motion sets the factors in every step
  }
}

}  // namespace netloft::scenes
