// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/scene_draft.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::scenes::femnet {

namespace {

void note_of_meshes(SceneDraft& to, const Panel& p, std::size_t number) {
  const std::string what = "panel " + std::to_string(number + 1);
  if (p.opening > 0)
    to.note(p.place, what,
            "here meshes resist opening with the gradient of an energy; FEMNET multiplies it by 2 cos(half "
            "angle)");
  if (p.knot_size > 0) to.note(p.place, what, "in the scene, knots that touch have an energy of their own");
}

InlineTable twine_of(SceneDraft& to, const Panel& p, double EA, double EA_compression) {
  InlineTable twine;
  twine.add("diameter", to.within(p.diameter, 0, 1, p.place, "the diameter of twines"));
  twine.add("EA", to.within(EA, 0, 1e12, p.place, "the stiffness of twines"));
  twine.add("EA_compression", to.within(EA_compression, 0, 1e12, p.place, "their stiffness in compression"));
  twine.add("density", to.within(p.density, 0, 1e6, p.place, "the density of twines"));
  if (p.opening > 0) {
    const double H = p.EI != 0 ? 6 * p.EI / p.side : p.opening;
    twine.add("opening_stiffness", to.within(H, 0, 1e6, p.place, "the opening stiffness"));
    twine.add("opening_angle", to.within(p.neutral_angle, 0, 1.5707, p.place, "the neutral angle"));
  }
  twine.add_unless_zero("knot_size", to.within(p.knot_size, 0, 10, p.place, "the size of knots"));
  return twine.add("surface", 1);
}

/// Writes netting with one bar for n twines. In FEMNET such a bar is one thick twine, and its tangential drag
/// (friction) is too large by the factor √n. The scene multiplies the friction by √n, so that its results
/// agree with those of FEMNET.
void write_twines(SceneDraft& to, std::size_t number, const std::string& region) {
  const Panel& p = to.gear.panels[number];
  const TwineBar bar(p);
  to.begin_part(region, "lumped/net", "one bar for " + formats::spell_number(p.twines) + " twines");
  to.stands_on_mesh();
  to.line("panel", InlineTable()
                       .add("bar", to.within(bar.length / bar.sides, 1e-6, 100, p.place, "the mesh side"))
                       .text());
  InlineTable twine;
  twine.add("diameter", to.within(p.diameter, 0, 1, p.place, "the diameter of twines"));
  twine.add("EA", to.within(bar.EA / p.twines, 0, 1e12, p.place, "the stiffness of twines"));
  twine.add("EA_compression",
            to.within(bar.EA_compression / p.twines, 0, 1e12, p.place, "their stiffness in compression"));
  twine.add("density", to.within(p.density, 0, 1e6, p.place, "the density of twines"));
  to.line("twine", twine.add("surface", 1).text());
  to.write_drag(p.cd, p.friction * std::sqrt(p.twines), p.place);
}

void write_panel(SceneDraft& to, std::size_t number) {
  const Panel& p = to.gear.panels[number];
  const std::string name = panel_name(number);
  const formats::MeshRegion* region = to.out.mesh.find(name);
  if (!region) return to.note(p.place, "panel " + std::to_string(number + 1), "has no elements in the mesh");
  if (region->kind == formats::RegionKind::twines) return write_twines(to, number, name);
  to.begin_part(name, "priour/triangle");
  to.stands_on_mesh();
  to.line("panel", InlineTable().add("bar", to.within(p.side, 1e-6, 100, p.place, "the mesh side")).text());
  to.line("twine", twine_of(to, p, p.EA, p.EA_compression).text());
  const bool has_drag = to.environment().drag_type != 3 && to.environment().drag_type != 4;
  to.write_drag(has_drag ? p.cd : 0, p.friction, p.place);
  note_of_meshes(to, p, number);
  if (to.out.mesh.find(name + "-twines")) write_twines(to, number, name + "-twines");
}

/// Initial position of the front of the catch along the current. A fifth of the length of the netting lies
/// behind this position.
double first_front(const SceneDraft& from) {
  double low = 1e6, high = -1e6;
  for (const auto& t : from.file.triangles)
    for (const auto node : t.nodes) {
      const auto& at = from.file.nodes[node].at;
      const double along = at[0] * std::cos(from.flow_angle()) + at[1] * std::sin(from.flow_angle());
      low = std::min(low, along);
      high = std::max(high, along);
    }
  return high - 0.2 * (high - low);
}

}  // namespace

void write_netting(SceneDraft& to) {
  for (std::size_t p = 0; p < to.gear.panels.size(); ++p) write_panel(to, p);
}

void write_catch(SceneDraft& to) {
  const Environment& e = to.environment();
  std::vector<std::string> on;
  for (std::size_t p = 0; p < to.gear.panels.size(); ++p)
    if (const auto* region = to.out.mesh.find(panel_name(p));
        region && region->kind == formats::RegionKind::triangles)
      on.push_back(region->name);
  if (e.catch_volume <= e.catch_accuracy || !to.has_current()) return;
  if (on.empty()) return to.note({}, "the catch", "there is no netting in triangles for it to press on");
  to.begin_part("catch", "catch/front", "on all netting behind a plane across the current");
  to.line("on", quoted_list(on));
  to.line("catch", InlineTable()
                       .add("volume", to.within(e.catch_volume, 0, 1e5, {}, "the volume of the catch"))
                       .add("speed", std::abs(e.speed))
                       .add("drag_coefficient",
                            to.within(e.catch_coefficient, 0, 1e3, {}, "the coefficient of the catch"))
                       .add("direction", to.heading())
                       .add("front", first_front(to))
                       .text());
  to.note(
      {}, "the catch",
      "here, netting behind the front of the catch has drag like other netting; FEMNET gives it none, and "
      "turns all other drag of netting towards x");
}

}  // namespace netloft::scenes::femnet
