// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/femnet_gear.hpp"

#include <algorithm>

namespace netloft::scenes::femnet {

namespace {

template <class T, class Is>
bool any(const std::vector<T>& all, Is&& is) {
  return std::any_of(all.begin(), all.end(), is);
}

bool is_any_set(const Triple& t) { return t != Triple{}; }

}  // namespace

std::vector<std::string> features_of(const GearFile& gear) {
  const Environment& e = gear.environment;
  const auto has_type = [&](Triple NodeType::*member) {
    return any(gear.types, [&](const NodeType& t) { return is_any_set(t.*member); });
  };
  const auto has_sense = [&](double sense) {
    return any(gear.types, [&](const NodeType& t) { return t.sense[2] == sense; });
  };
  const std::pair<const char*, bool> all[] = {
      {"netting in triangles", any(gear.panels, [](const Panel& p) { return p.twines == 0; })},
      {"bars for several twines", any(gear.panels, [](const Panel& p) { return p.twines > 0; })},
      {"panels of more or fewer than four corners",
       any(gear.panels, [](const Panel& p) { return p.corners.size() != 4; })},
      {"opening stiffness", any(gear.panels, [](const Panel& p) { return p.opening > 0; })},
      {"knots that touch", any(gear.panels, [](const Panel& p) { return p.knot_size > 0; })},
      {"ropes", !gear.cables.empty()},
      {"spheres on ropes", any(gear.cables, [](const Cable& c) { return !c.floats.empty(); })},
      {"ropes that bend", any(gear.cables, [](const Cable& c) { return c.EI > 0; })},
      {"clamps", !gear.clamps.empty()},
      {"constant tension", any(gear.cables, [](const Cable& c) { return c.constant_tension > 0; })},
      {"masses", has_type(&NodeType::mass)},
      {"boxes", has_type(&NodeType::box)},
      {"forces at nodes", has_type(&NodeType::force)},
      {"half a gear", has_type(&NodeType::symmetry)},
      {"a bed", has_sense(1) && e.bed_stiffness != 0},
      {"a moving bed with friction", has_sense(1) && e.bed_moves && e.bed_friction != 0},
      {"a catch with a plane front", e.catch_volume > e.catch_accuracy},
      {"no drag on netting", e.drag_type == 3 || e.drag_type == 4},
      {"another density of water", e.water_density != 1025},
      {"joints by distance", gear.link_distance > 0},
      {"waves", e.wave_height != 0},
      {"hauling at a drum", !gear.drums.empty()},
      {"nodes that move", !gear.motions.empty()}};
  std::vector<std::string> needed;
  for (const auto& [name, is_needed] : all)
    if (is_needed) needed.emplace_back(name);
  return needed;
}

}  // namespace netloft::scenes::femnet
