// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/degrees.hpp"
#include "io/scenes/import/scene_draft.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::scenes::femnet {

namespace {

/// A comment for a cable: the names of its requested outputs, and its floats.
std::string called(const SceneDraft& from, std::size_t cable) {
  std::string names;
  for (const auto& w : from.gear.wanted)
    if (w.kind == Wanted::Kind::tension && w.first == static_cast<int>(cable) + 1)
      names += (names.empty() ? "" : ", ") + in_ascii(w.text);
  const std::string& floats = from.gear.cables[cable].floats;
  return names + (names.empty() || floats.empty() ? "" : "; ") + floats;
}

/// Writes a part of a cable: without `hauled`, the part with all bars that no drum hauls; with `hauled`, the
/// part with this one bar that a drum hauls.
void write_bars(SceneDraft& to, const Cable& c, const std::string& name, const std::string& comment,
                const HauledBar* hauled) {
  to.begin_part(name, "rope/bar", comment);
  to.stands_on_mesh();
  to.line("length", to.within(c.length, 1e-6, 1e6, c.place, "the length of the cable"));
  InlineTable rope;
  rope.add("diameter", to.within(c.diameter, 0, 10, c.place, "the diameter of the cable"));
  rope.add("EA", to.within(c.EA, 0, 1e15, c.place, "the stiffness of the cable"));
  rope.add("EA_compression", to.within(c.EA_compression, 0, 1e15, c.place, "its stiffness in compression"));
  rope.add("density", to.within(c.density, 0, 1e6, c.place, "the density of the cable"));
  if (c.EI > 0)
    rope.add("EI", to.within(c.EI, 0, 1e12, c.place, "its bending stiffness"))
        .add("curvature", quoted("nodes"));
  rope.add_unless_zero("constant_tension", to.within(c.constant_tension, 0, 1e12, c.place, "its tension"));
  rope.add("surface", 1);
  if (hauled)
    rope.add("length_share",
             InlineTable().add("t", list_of(hauled->times)).add("share", list_of(hauled->shares)).text());
  to.line("rope", rope.text());
  to.write_drag(c.cd, c.friction, c.place);
}

/// The sum of the extents along `axis` [m] of all bars that have exactly one end in a plane. It is positive
/// if these bars lie on the positive side of the plane, zero if there are none.
double side_of_bars(const SceneDraft& from, const std::vector<std::uint32_t>& bars,
                    const std::vector<std::uint32_t>& plane, std::size_t axis) {
  const auto is_there = [&](auto n) { return std::find(plane.begin(), plane.end(), n) != plane.end(); };
  double side = 0;
  for (std::size_t b = 0; b + 1 < bars.size(); b += 2)
    if (is_there(bars[b]) != is_there(bars[b + 1]))
      side += (is_there(bars[b]) ? 1 : -1) *
              (from.file.nodes[bars[b + 1]].at[axis] - from.file.nodes[bars[b]].at[axis]);
  return side;
}

/// Writes a part with bending elements at a plane of symmetry, between bars that end in it and the mirror
/// images of these bars.
void write_mirrors(SceneDraft& to, const Cable& c, std::size_t number) {
  const formats::MeshRegion* region = to.out.mesh.find(cable_name(number));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto plane = std::find_if(to.out.mesh.sets.begin(), to.out.mesh.sets.end(),
                                    [&](const auto& set) { return set.name == plane_name(axis); });
    const double side =
        plane == to.out.mesh.sets.end() || !region ? 0 : side_of_bars(to, region->nodes, plane->nodes, axis);
    if (side == 0) continue;
    to.begin_part("mirror-" + std::to_string(number + 1) + kAxis[axis], "rope/mirror");
    to.line("on", quoted(cable_name(number) + "." + plane_name(axis)));
    to.line("mirror", InlineTable()
                          .add("EI", c.EI)
                          .add("axis", quoted(kAxis[axis]))
                          .add("side", quoted(side > 0 ? "positive" : "negative"))
                          .add("curvature", quoted("nodes"))
                          .text());
  }
}

void write_cable(SceneDraft& to, std::size_t number) {
  const Cable& c = to.gear.cables[number];
  const std::string what = "cable " + std::to_string(number + 1);
  bool is_there = to.out.mesh.find(cable_name(number));
  if (is_there) write_bars(to, c, cable_name(number), called(to, number), nullptr);
  for (const auto& h : to.hauled) {
    if (to.file.bars[h.bar].cable != static_cast<int>(number) + 1) continue;
    write_bars(to, c, bar_name(number, h.number), is_there ? "" : called(to, number), &h);
    is_there = true;
  }
  if (!is_there) return to.note(c.place, what, "has no bars in the mesh");
  if (c.EI > 0) write_mirrors(to, c, number);
  if (c.constant_tension > 0)
    to.note(c.place, what, "its tension is constant, also where FEMNET lets it fall");
}

bool do_meet(const SceneDraft& from, std::size_t first, std::size_t second) {
  const formats::MeshRegion *a = from.out.mesh.find(cable_name(first)),
                            *b = from.out.mesh.find(cable_name(second));
  return a && b && first != second && std::any_of(a->nodes.begin(), a->nodes.end(), [&](auto node) {
           return std::find(b->nodes.begin(), b->nodes.end(), node) != b->nodes.end();
         });
}

}  // namespace

void find_hauled(SceneDraft& to) {
  const auto hauled = haul(to.gear, to.file);
  if (hauled) to.hauled = *hauled;
  for (const Drum& d : to.gear.drums) {
    const std::string what = "the drum of cable " + std::to_string(d.cable + 1);
    if (!hauled) to.leave_out(d.place, what, "takes too many steps");
    if (to.gear.cables[static_cast<std::size_t>(d.cable)].EI > 0)
      to.leave_out(d.place, what, "the cable has bending stiffness, except where the drum shortens it");
  }
}

void write_cables(SceneDraft& to) {
  for (std::size_t c = 0; c < to.gear.cables.size(); ++c) write_cable(to, c);
}

/// Writes the clamps, each with the smaller of the two bending stiffnesses of its cables. If the cables do
/// not meet or have no bending stiffness, the clamp is left out, with a note.
void write_clamps(SceneDraft& to) {
  for (std::size_t i = 0; i < to.gear.clamps.size(); ++i) {
    const Clamp& clamp = to.gear.clamps[i];
    const auto first = static_cast<std::size_t>(clamp.first), second = static_cast<std::size_t>(clamp.second);
    const std::string what = "cables " + std::to_string(first + 1) + " and " + std::to_string(second + 1);
    const double EI = std::min(to.gear.cables[first].EI, to.gear.cables[second].EI);
    if (!do_meet(to, first, second) || !(EI > 0)) {
      to.note(clamp.place, what,
              EI > 0 ? "do not meet: they cannot be clamped"
                     : "have no bending stiffness, so that their clamp has no effect");
      continue;
    }
    to.begin_part("clamp-" + std::to_string(i + 1), "rope/clamp");
    to.line("on", quoted_list({cable_name(first), cable_name(second)}));
    const double turn =
        to.within(180 - clamp.angle, 0, 180, clamp.place, "180 degrees less the angle of the clamp");
    to.line("clamp", InlineTable()
                         .add("EI", to.within(EI, 0, 1e12, clamp.place, "the stiffness of the clamp"))
                         .add("angle", formats::in_radians(turn))
                         .add("curvature", quoted("nodes"))
                         .text());
  }
}

}  // namespace netloft::scenes::femnet
