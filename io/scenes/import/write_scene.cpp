// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/degrees.hpp"
#include "io/scenes/import/imported_motion.hpp"
#include "io/scenes/import/scene_draft.hpp"

#include <cmath>

namespace netloft::scenes::femnet {

namespace {

std::string header(const SceneDraft& from) {
  const bool is_divided = from.names.mesh.empty();
  std::string text = "# Imported from " + in_ascii(from.names.gear) +
                     (is_divided ? ", a file" : " and " + in_ascii(from.names.mesh) + ", files") +
                     " of FEMNET. Names have the numbers " +
                     (is_divided ? "of that file" : "of those files") + ".\n";
  text +=
      "# FEMNET keeps numbers of netting in single precision; they are written with that precision here.\n";
  for (const auto& f : from.out.findings)
    text += std::string("# ") + (f.kind == Finding::Kind::note ? "note" : "left out") + ", line " +
            std::to_string(f.place.line) + ", " + in_ascii(f.what) + ": " + in_ascii(f.text) + "\n";
  return text;
}

std::string water(const SceneDraft& from) {
  const Environment& e = from.environment();
  std::string text = "\n[water]\ndensity = " + formats::spell_number(e.water_density) +
                     "\ngravity = " + formats::spell_number(kGravity) + "\n";
  if (from.has_waves()) text += waves_text(e) + "\n";
  if (!from.has_current()) return text;
  if (from.is_towed())
    return text +
           "\n[tow]  # the bed passes with the water\nspeed = " + formats::spell_number(std::abs(e.speed)) +
           "\nleeway = " + formats::spell_number(from.heading()) + "\n";
  const double psi = formats::in_radians(e.direction);
  const double x = e.speed * std::cos(psi), y = e.direction == 180 ? 0 : e.speed * std::sin(psi);
  return text + "current = [" + formats::spell_number(x) + ", " + formats::spell_number(y) + ", 0]\n";
}

void note_motion(SceneDraft& to) {
  const std::string cure = "left out, because the scene is at rest; --motion writes the motion";
  if (to.environment().wave_height != 0) to.note(to.environment().waves, "waves", "are " + cure);
  for (const auto& f : to.gear.of_motion)
    to.note(f.place, f.what, "is left out, because the scene is at rest");
  for (const auto& d : to.gear.drums) to.note(d.place, "keyword hauling_cable4", "is " + cure);
  for (const auto& m : to.gear.motions) to.note(m.place, "keyword speed_type_node2", "is " + cure);
}

void note_waves(SceneDraft& to) {
  const Environment& e = to.environment();
  if (e.wave_height == 0) return;
  if (const auto fault = fault_of_waves(e); !fault.empty()) return to.leave_out(e.waves, "waves", fault);
  to.note(e.waves, "waves",
          "grow over one period as in FEMNET, but smoothly; in deep water (more than half a wave length) "
          "waves are computed for this depth, too");
  if (e.wave_model != 1)
    to.note(e.waves, "waves",
            "are linear here; with waves of a higher order, crests would rise by " +
                formats::spell_number(std::round(1e4 * rise_of_second_order(e)) / 1e4) + " m more");
  if (to.is_towed())
    to.note(e.waves, "waves", "are carried along by the passing water; in FEMNET they are not");
}

void note_masses(SceneDraft& to, std::size_t number) {
  const NodeType& t = to.gear.types[number];
  const std::string what = "type " + std::to_string(number + 1);
  const auto differ = [](const Triple& m) { return m[0] != m[2] || m[1] != m[2]; };
  if (differ(t.mass) || !(t.mass[2] >= 0 && t.mass[2] <= kMostMass))
    to.note(t.place, what, "the node has the same mass along all axes, that along z, if that is above zero");
  if (differ(t.added_mass))
    to.note(t.place, what, "the node has the same added mass along all axes, their mean");
  if (t.sense[2] == 1 && to.environment().bed_friction != 0 && !to.is_towed())
    to.leave_out(t.place, what,
                 "friction of a bed at rest, on nodes that slide over it, is not carried over");
}

void note_differences_of_motion(SceneDraft& to) {
  to.out.findings.insert(to.out.findings.end(), to.gear.of_motion.begin(), to.gear.of_motion.end());
  note_waves(to);
  to.note(
      {}, "the motion",
      "in the scene, ropes have added mass only across their direction, in FEMNET along it, too; time steps "
      "of FEMNET damp fast motions, those of the scene hardly");
  const Environment& e = to.environment();
  if (e.record_begin > 0) to.note({}, "the record", "begins at 0 here");
  for (std::size_t t = 0; t < to.gear.types.size(); ++t)
    if (to.has_nodes(t)) note_masses(to, t);
}

std::string scene_text(const SceneDraft& from) { return header(from) + water(from) + from.body.text(); }

}  // namespace

Imported import_gear(const GearFile& gear, const MeshFile& mesh, const Names& names,
                     formats::Diagnostics& diagnostics, Sought sought) {
  SceneDraft draft(gear, mesh, names, diagnostics, sought);
  if (draft.moves) find_hauled(draft);
  draft.out.mesh = make_mesh(gear, mesh, draft.hauled);
  write_netting(draft);
  write_cables(draft);
  write_loads(draft);
  write_clamps(draft);
  write_catch(draft);
  write_holds(draft);
  hold_what_is_loose(draft);
  write_results(draft);
  draft.moves ? note_differences_of_motion(draft) : note_motion(draft);
  if (draft.moves) draft.body.add(motion_text(draft.environment()));
  draft.out.scene = scene_text(draft);
  return std::move(draft.out);
}

}  // namespace netloft::scenes::femnet
