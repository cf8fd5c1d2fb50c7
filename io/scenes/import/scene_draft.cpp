// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/scene_draft.hpp"

#include "io/formats/units/degrees.hpp"
#include "io/scenes/import/imported_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netloft::scenes::femnet {

bool SceneDraft::has_waves() const {
  return moves && environment().wave_height != 0 && fault_of_waves(environment()).empty();
}

bool SceneDraft::is_towed() const {
  const Environment& e = environment();
  if (!e.bed_moves || e.bed_friction == 0 || !has_current()) return false;
  for (std::size_t t = 0; t < gear.types.size(); ++t)
    if (gear.types[t].sense[2] == 1 && has_nodes(t)) return true;
  return false;
}

double SceneDraft::flow_angle() const {
  return formats::in_radians(environment().direction) + (environment().speed < 0 ? std::numbers::pi : 0);
}

double SceneDraft::heading() const { return std::remainder(flow_angle(), 2 * std::numbers::pi); }

bool SceneDraft::has_nodes(std::size_t type) const {
  return std::any_of(out.mesh.sets.begin(), out.mesh.sets.end(),
                     [&](const auto& set) { return set.name == type_name(type); });
}

double SceneDraft::within(double value, double lo, double hi, const formats::Place& place,
                          const std::string& what) {
  if (!(value >= lo && value <= hi))
    diagnostics_.error(place, what + " = " + formats::spell_number(value) + " is outside [" +
                                  formats::spell_number(lo) + ", " + formats::spell_number(hi) + "]");
  return value;
}

void SceneDraft::write_drag(double cd, double friction, const formats::Place& place) {
  if (!has_flow()) return;
  line("drag", InlineTable()
                   .add("law", quoted("hydro/morison"))
                   .add("normal", within(cd, 0, 100, place, "the normal drag coefficient"))
                   .add("tangential", within(cd * friction, 0, 100, place, "the tangential drag coefficient"))
                   .text());
}

std::string list_of(const std::vector<double>& numbers) {
  std::string list;
  for (const double x : numbers)
    list += (list.empty() ? "" : ", ") + formats::spell_number(std::round(x * 1e9) / 1e9);
  return "[" + list + "]";
}

}  // namespace netloft::scenes::femnet
