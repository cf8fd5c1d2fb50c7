// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/division.hpp"

#include "io/gears/meshing/cannot_divide.hpp"
#include "io/gears/meshing/gear_size.hpp"
#include "io/gears/meshing/seam_lines.hpp"

#include <tuple>

namespace netloft::gears {

namespace {

std::vector<MeshCount> without_places(std::vector<MeshCount> counts) {
  for (MeshCount& count : counts) count.place = {};
  return counts;
}

std::vector<Cut> without_places(std::vector<Cut> side) {
  for (Cut& cut : side) cut.place = {};
  return side;
}

Panel geometry_of(const Panel& panel) {
  Panel shape;
  shape.name = panel.name;
  shape.stands = panel.stands;
  shape.mesh = panel.mesh;
  shape.orientation = panel.orientation;
  shape.angle = panel.angle;
  shape.fore = without_places(panel.fore);
  shape.aft = without_places(panel.aft);
  shape.states_aft = panel.states_aft;
  shape.depth = panel.depth;
  shape.pieces = panel.pieces;
  shape.has_corners = panel.has_corners;
  shape.is_round = panel.is_round;
  shape.outer = without_places(panel.outer);
  shape.inner = without_places(panel.inner);
  shape.outline = panel.outline;
  return shape;
}

Rope geometry_of(const Rope& rope) {
  Rope shape;
  shape.name = rope.name;
  shape.stands = rope.stands;
  shape.length = rope.length;
  shape.length_port = rope.length_port;
  shape.role = rope.role;
  shape.between = rope.between;
  shape.is_selvedge = rope.is_selvedge;
  return shape;
}

}  // namespace

NetPlan geometry_of(const NetPlan& plan) {
  NetPlan shape;
  for (const Panel& panel : plan.panels) shape.panels.push_back(geometry_of(panel));
  for (const Rope& rope : plan.ropes) shape.ropes.push_back(geometry_of(rope));
  for (const Hanging& hanging : plan.hangings)
    shape.hangings.push_back({hanging.edge, hanging.rope, hanging.length, hanging.ratio, {}, {}, {}});
  for (const Join& join : plan.joins)
    shape.joins.push_back({join.edges, join.take_up, join.selvedge, {}, {}});
  for (const Point& point : plan.points) shape.points.push_back({point.name, point.stands, {}, {}});
  for (const PlanBody& body : plan.bodies) shape.bodies.push_back({body.name, body.stands, body.points, {}});
  return shape;
}

namespace {

bool is_same(const Rope& a, const Rope& b) {
  const auto all = [](const Rope& r) {
    return std::tie(r.name, r.stands, r.length, r.length_port, r.role, r.between, r.is_selvedge);
  };
  return all(a) == all(b);
}

/// Throws CannotDivide if a seam of the whole gear cannot be sewn.
void require_sewable(const NetPlan& plan) {
  const Gear gear = make_gear(plan, Extent::whole);
  const Fineness usual;
  try {
    seam_lines(gear, cloths_of(gear), usual, size_for(gear, usual));
  } catch (const CannotDivide&) {
    throw;
  } catch (const std::invalid_argument&) {
    return;  // too many elements: the division itself reports this
  }
}

}  // namespace

void check_seams(const NetPlan& plan, formats::Diagnostics& diagnostics) {
  try {
    require_sewable(plan);
  } catch (const CannotDivide& refused) {
    refused.report(plan, diagnostics);
  }
}

bool DivisionInput::operator==(const DivisionInput& other) const {
  const NetPlan &a = geometry, &b = other.geometry;
  return extent == other.extent && fineness == other.fineness && like == other.like && a.panels == b.panels &&
         std::ranges::equal(a.ropes, b.ropes, is_same) && a.hangings == b.hangings && a.joins == b.joins &&
         a.points == b.points && a.bodies == b.bodies;
}

Division::Division(DivisionInput input)
    : input_(std::move(input)),
      gear_(make_gear(input_.geometry, input_.extent)),
      mesh_(input_.like ? divide_alike(gear_, input_.fineness, *input_.like->mesh().topology)
                        : divide(gear_, input_.fineness)) {
  if (!input_.like) shapes_.emplace(gear_, mesh_);
}

std::shared_ptr<Division> Divisions::of(const NetPlan& plan, Extent extent, const Fineness& fineness,
                                        const std::shared_ptr<Division>& like) {
  return recent_.of({geometry_of(plan), extent, fineness, like}, [](const DivisionInput& input) {
    const bool is_sewn = input.like != nullptr;  // its seams are those of the other gear
    if (input.extent == Extent::half && !is_sewn)
      require_sewable(input.geometry);  // for a whole gear, the division itself finds such seams
    return std::make_shared<Division>(input);
  });
}

}  // namespace netloft::gears
