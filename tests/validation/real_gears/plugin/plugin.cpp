// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/plugin/bend.hpp"
#include "tests/validation/real_gears/plugin/node.hpp"
#include "tests/validation/real_gears/plugin/surface.hpp"

using namespace netloft;
using namespace netloft::femnet;

namespace {

constexpr std::uint32_t kDragBySurface = reads_current | reads_velocity | needs_flow | from_outside | is_drag;

void add_dry_netting(Plugin& plugin) {
  using priour::Triangle;
  auto& e = plugin.element<Triangle>("dry_netting", "What priour/triangle loses above the surface");
  e.real("twine.diameter", &Triangle::Parameters::diameter, "m", "diameter of one twine", {.lo = 0, .hi = 1});
  e.law("drag", NETLOFT_TWINE_LAW, "hydro/morison", "force of the water on the netting below the surface");
  e.data("u", &Triangle::Data::u, "1", "twine coordinate of the corners along u, in bars");
  e.data("v", &Triangle::Data::v, "1", "twine coordinate of the corners along v, in bars");
  e.data("bar_length", &Triangle::Data::bar_length, "m", "unstretched length of a bar, from knot to knot");
  e.term<DryNettingDrag, kDragBySurface>("drag", "drag that dry netting has not");
}

void add_dry_bar(Plugin& plugin) {
  using rope::Bar;
  auto& e = plugin.element<Bar>("dry_bar", "What rope/bar loses above the surface");
  e.real("rope.diameter", &Bar::Parameters::diameter, "m", "diameter of the rope", {.lo = 0, .hi = 10});
  e.law("drag", NETLOFT_TWINE_LAW, "hydro/morison", "force of the water on the rope below the surface");
  e.data("rest_length", &Bar::Data::rest_length, "m", "unstretched length of the bar");
  e.term<DryBarDrag, kDragBySurface>("drag", "drag that a dry rope has not");
  e.term<DryBarBuoyancy, conservative | symmetric | needs_gravity | from_outside | is_weight>(
      "buoyancy", "buoyancy that a dry rope has not");
}

void add_node(Plugin& plugin) {
  auto& e = plugin.element<Node>("node", "Force, weight, buoyant box and limits of a node");
  e.real("limit.stiffness", &Node::Parameters::stiffness, "N/m", "force per metre beyond a limit",
         {.lo = 0, .hi = 1e12, .fallback = 0});
  e.real("limit.friction", &Node::Parameters::friction, "1", "force along the current over force of the bed",
         {.lo = 0, .hi = 10, .fallback = 0});
  e.data("force", &Node::Data::force, "N", "constant force");
  e.data("box", &Node::Data::box, "m", "sides of the buoyant box");
  e.data("limit", &Node::Data::limit, "m", "bounds of the coordinates");
  e.data("sense", &Node::Data::sense, "1", "1: lower bound, -1: upper bound, 0: none");
  e.data("mass", &Node::Data::mass, "kg", "mass, of which the weight acts");
  e.data("share", &Node::Data::share, "1", "share of the node in this model");
  e.term<Node::Load, conservative | symmetric | constant | from_outside>("load", "constant force and weight");
  e.term<Node::Buoyancy, conservative | symmetric | needs_gravity | from_outside | is_weight>(
      "buoyancy", "buoyancy of the box below the surface");
  e.term<Node::Limit, conservative | symmetric | has_convex | has_metric | from_outside>(
      "limit", "push back within the limits", "limit.stiffness");
  e.term<Node::Friction, reads_current | needs_flow | from_outside>(
      "friction", "force along the current of a bed that moves", "limit.friction");
}

void add_bend(Plugin& plugin) {
  auto& e = plugin.element<Bend>("bend", "Moment between two bars by the circle through their nodes");
  e.real("rope.EI", &Bend::Parameters::EI, "N m2", "bending stiffness of the rope", {.lo = 0, .hi = 1e12});
  e.data("rest_length", &Bend::Data::rest_length, "m", "unstretched length of both bars");
  e.term<Bend::Moment>("moment", "moment against the curvature of the rope");
}

}  // namespace

NETLOFT_PLUGIN("femnet", "1.0", "What FEMNET has and Netloft has not, for comparing the two") {
  add_dry_netting(plugin);
  add_dry_bar(plugin);
  add_node(plugin);
  add_bend(plugin);
}
