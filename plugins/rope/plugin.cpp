// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/rope/bar.hpp"

using netloft::rope::Bar;

NETLOFT_PLUGIN("rope", "0.1.0", "Ropes, wires and chains as elastic bars") {
  auto& bar = plugin.element<Bar>("bar", "Straight elastic bar of a rope between two nodes, weak when slack");
  bar.real("rope.EA", &Bar::Parameters::EA, "N", "axial stiffness of the rope", {.lo = 0, .hi = 1e15});
  bar.real("rope.EA_compression", &Bar::Parameters::EA_compression, "N", "axial stiffness when slack",
           {.lo = 0, .hi = 1e15, .fallback = 1e-4, .fallback_of = "rope.EA"});
  bar.real("rope.diameter", &Bar::Parameters::diameter, "m", "diameter of the rope", {.lo = 0, .hi = 10});
  bar.real("rope.density", &Bar::Parameters::density, "kg/m3", "density of the rope's material",
           {.lo = 0, .hi = 3e4});
  bar.data("rest_length", &Bar::Data::rest_length, "m", "unstretched length of the bar");
  bar.term<Bar::Elastic,
           netloft::conservative | netloft::symmetric | netloft::has_convex | netloft::has_metric>(
      "elastic", "tension of the rope, and its small resistance when slack");
  bar.term<Bar::Weight, netloft::conservative | netloft::symmetric | netloft::constant |
                            netloft::needs_gravity>("weight", "weight in water of the unstretched rope");
  bar.output("tension", "N", "tension, positive when the rope pulls",
             [](auto& p, auto& d, auto& s) { return Bar::stretch(p, d, s).T; });
  bar.output("strain", "1", "elongation over unstretched length",
             [](auto& p, auto& d, auto& s) { return Bar::stretch(p, d, s).l / d.rest_length - 1; });
}
