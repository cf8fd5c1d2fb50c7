// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/scene_draft.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::scenes::femnet {

namespace {

/// The fraction of the load of a node that acts on the modelled half of the gear. Each plane of symmetry that
/// contains the node halves the load.
double share_of(const NodeType& t) {
  double share = 1;
  for (const double plane : t.symmetry) share *= plane != 0 ? 0.5 : 1;
  return share;
}

void begin_load(SceneDraft& to, const std::string& name, const std::string& type, std::size_t on) {
  const double share = share_of(to.gear.types[on]);
  to.begin_part(name + "-" + std::to_string(on + 1), type);
  to.line("on", quoted("*." + type_name(on)));
  to.body.line("each", formats::spell_number(share) +
                           (share == 1 ? "" : "  # fraction of each on this side of the plane of symmetry"));
}

/// The mean added mass over the axes, because a scene has one added mass for all axes.
double added_mass_of(const NodeType& t) { return (t.added_mass[0] + t.added_mass[1] + t.added_mass[2]) / 3; }

void write_box(SceneDraft& to, std::size_t number, bool has_mass) {
  const NodeType& t = to.gear.types[number];
  const auto side = [&](std::size_t axis) {
    return to.within(std::abs(t.box[axis]), 0, 1e3, t.place, "a length of the box");
  };
  const auto drag = [&](std::size_t axis) {
    return to.within(t.drag[axis], 0, 1e4, t.place, "a drag coefficient of the box");
  };
  begin_load(to, "box", "float/box", number);
  InlineTable box;
  if (has_mass) box.add("mass", t.mass[2]);
  if (to.moves)
    box.add_unless_zero("added_mass", to.within(added_mass_of(t), 0, 1e7, t.place, "the added mass"));
  box.add("length_x", side(0)).add("length_y", side(1)).add("height", side(2));
  if (t.box[2] < 0) box.add("hangs", std::string("true"));
  if (to.has_flow()) box.add("drag_x", drag(0)).add("drag_y", drag(1)).add("drag_z", drag(2));
  to.line("box", box.text());
}

void write_limits(SceneDraft& to, std::size_t number) {
  const NodeType& t = to.gear.types[number];
  const double k = to.environment().bed_stiffness;
  if (t.sense == Triple{} || k == 0) return;
  const std::string what = "type " + std::to_string(number + 1);
  if (t.sense[0] != 0 || t.sense[1] != 0 || t.sense[2] < 0 || t.sense[2] == 2)
    to.leave_out(t.place, what, "limits other than a bed below the node are not modelled here");
  if (t.sense[2] != 1) return;
  begin_load(to, "bed", "seabed/plane", number);
  InlineTable bed;
  bed.add("depth", to.within(-t.limit[2], -1e6, 1e6, t.place, "the depth of the bed"));
  bed.add("stiffness", to.within(k, 0, 1e12, t.place, "the stiffness of the bed")).add("softness", 0);
  if (to.is_towed())
    bed.add("friction", to.within(to.environment().bed_friction, 0, 10, t.place, "the friction of the bed"));
  to.line("seabed", bed.text());
}

void write_loads(SceneDraft& to, std::size_t number) {
  if (!to.has_nodes(number)) return;
  const NodeType& t = to.gear.types[number];
  const bool has_box = t.box[0] != 0 && t.box[1] != 0 && t.box[2] != 0;
  const bool has_mass = t.mass[2] > 0 && t.mass[2] <= kMostMass;
  Triple force = t.force;
  if (!has_mass) force[2] -= t.mass[2] * kGravity;
  const bool has_added_mass = to.moves && added_mass_of(t) > 0;
  if (has_box || has_added_mass)
    write_box(to, number, has_mass);
  else if (has_mass) {
    begin_load(to, "mass", "float/float", number);
    to.line("float", InlineTable().add("mass", t.mass[2]).text());
  }
  if (force != Triple{}) {
    begin_load(to, "force", "force/constant", number);
    InlineTable table;
    for (std::size_t axis = 0; axis < 3; ++axis)
      table.add_unless_zero(kAxis[axis], to.within(force[axis], -1e9, 1e9, t.place, "the force"));
    to.line("force", table.text());
  }
  write_limits(to, number);
}

/// Writes the velocity of a hold. After the last time, the velocity falls to zero within one time step. If
/// the first time is later than zero, the velocity is zero until one time step before the first time.
void write_velocity(SceneDraft& to, const NodeMotion& m, bool is_held) {
  const double dt = to.environment().time_step > 0 ? to.environment().time_step : 0.01;
  const auto with_rests = [&](std::vector<double> all, double before, double after) {
    if (m.times.front() > 0) all.insert(all.begin(), before);
    all.push_back(after);
    return all;
  };
  InlineTable table;
  table.add("t", list_of(with_rests(m.times, m.times.front() - dt, m.times.back() + dt)));
  for (std::size_t axis = 0; axis < 3; ++axis)
    table.add(kAxis[axis], list_of(with_rests(m.velocity[axis], 0, 0)));
  to.line("velocity", table.text());
  if (!is_held && m.times.front() > 0)
    to.note(m.place, "keyword speed_type_node2",
            "in the scene, its nodes are held also before their motion begins");
}

void hold(SceneDraft& to, const std::string& set, const std::string& axes) {
  to.body.hold("*." + set, set, axes);
}

void write_hold(SceneDraft& to, std::size_t number) {
  if (!to.has_nodes(number)) return;
  const NodeType& t = to.gear.types[number];
  std::string axes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (t.fixed[axis] != 0 || t.symmetry[axis] != 0) axes += kAxis[axis];
  const auto moved = std::find_if(to.gear.motions.begin(), to.gear.motions.end(),
                                  [&](const auto& m) { return m.type == static_cast<int>(number); });
  const bool is_moved = to.moves && moved != to.gear.motions.end();
  if (axes.empty() && !is_moved) return;
  hold(to, type_name(number), is_moved ? "xyz" : axes);
  if (is_moved) write_velocity(to, *moved, axes == "xyz");
  std::string planes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (t.symmetry[axis] != 0) planes += std::string(planes.empty() ? "" : ", ") + kAxis[axis];
  if (!planes.empty()) to.body.comment("on the plane of symmetry across " + planes);
}

}  // namespace

void write_loads(SceneDraft& to) {
  for (std::size_t t = 0; t < to.gear.types.size(); ++t) write_loads(to, t);
}

void write_holds(SceneDraft& to) {
  for (std::size_t t = 0; t < to.gear.types.size(); ++t) write_hold(to, t);
}

void hold_what_is_loose(SceneDraft& to) {
  const auto loose = find_loose(to.gear, to.file);
  for (std::size_t i = 0; i < loose.size(); ++i) {
    std::string axes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (loose[i].axes[axis]) axes += kAxis[axis];
    hold(to, "loose-" + std::to_string(i + 1), axes);
    to.line("loose", "true");
    to.note({}, "node " + std::to_string(loose[i].node + 1),
            "is held along " + axes +
                ", because nothing in the file holds it there; an equilibrium in which this hold bears "
                "load is not valid");
  }
}

}  // namespace netloft::scenes::femnet
