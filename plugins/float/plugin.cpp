// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/float/box.hpp"
#include "plugins/float/float.hpp"

using netloft::floats::Box;
using netloft::floats::Float;

namespace {

void add_box(netloft::Plugin& plugin) {
  auto& b = plugin.element<Box>("box", "Upright box above or below a node, partly immersed");
  b.real("box.mass", &Box::Parameters::mass, "kg", "mass of one box", {.lo = 0, .hi = 1e7, .fallback = 0});
  const netloft::Real side{.lo = 0, .hi = 1e3, .fallback = 0};
  b.real("box.length_x", &Box::Parameters::length_x, "m", "side along x", side);
  b.real("box.length_y", &Box::Parameters::length_y, "m", "side along y", side);
  b.real("box.height", &Box::Parameters::height, "m", "height", side);
  b.boolean("box.hangs", &Box::Parameters::hangs,
            "the box hangs below its node: the upper face is at the node, instead of the lower one", false);
  const netloft::Real drag{.lo = 0, .hi = 1e4, .fallback = 0};
  b.real("box.drag_x", &Box::Parameters::drag_x, "1", "drag coefficient of the flow along x", drag);
  b.real("box.drag_y", &Box::Parameters::drag_y, "1", "drag coefficient of the flow along y", drag);
  b.real("box.drag_z", &Box::Parameters::drag_z, "1", "drag coefficient of the vertical flow", drag);
  b.real("box.added_mass", &Box::Parameters::added_mass, "kg", "added mass, the same along all axes",
         {.lo = 0, .hi = 1e7, .fallback = 0});
  b.data("pieces", &Box::Data::pieces, "1", "number of boxes at this node");
  b.term<Box::Buoyancy, netloft::conservative | netloft::symmetric | netloft::needs_gravity |
                            netloft::from_outside | netloft::is_weight | netloft::reads_waves>(
      "buoyancy", "buoyancy of the immersed part");
  b.term<Box::Weight, netloft::conservative | netloft::symmetric | netloft::constant |
                          netloft::needs_gravity | netloft::is_weight>("weight", "weight in air", "box.mass");
  b.term<Box::Drag, netloft::reads_velocity | netloft::reads_current | netloft::reads_waves |
                        netloft::needs_flow | netloft::from_outside | netloft::is_drag>(
      "drag", "force of the water on the immersed part", "box.drag_x box.drag_y box.drag_z");
  b.term<Box::Inertia, netloft::symmetric | netloft::reads_acceleration | netloft::needs_motion>(
      "inertia", "mass and added mass");
  b.term<Box::Waves,
         netloft::reads_waves | netloft::needs_waves | netloft::needs_motion | netloft::from_outside>(
      "waves", "pressure of the waves on the immersed part, and added mass of accelerated water");
}

}  // namespace

NETLOFT_PLUGIN("float", "0.1.0", "Floats and weights at nodes") {
  auto& f =
      plugin.element<Float>("float", "Floats at a node or along a rope; weights have negative buoyancy");
  f.real("float.buoyancy", &Float::Parameters::buoyancy, "N",
         "net upward force of one float in water; 0: computed from float.volume and float.mass",
         {.lo = -1e7, .hi = 1e7, .fallback = 0});
  f.real("float.volume", &Float::Parameters::volume, "m3", "volume of one float",
         {.lo = 0, .hi = 1e3, .fallback = 0});
  f.real("float.mass", &Float::Parameters::mass, "kg", "mass of one float",
         {.lo = 0, .hi = 1e6, .fallback = 0});
  f.real("float.diameter", &Float::Parameters::diameter, "m", "diameter across the flow",
         {.lo = 0, .hi = 20, .fallback = 0});
  f.real("float.area", &Float::Parameters::area, "m2",
         "area across the flow; 0: that of a circle with float.diameter",
         {.lo = 0, .hi = 1e3, .fallback = 0});
  f.real("float.drag_coefficient", &Float::Parameters::drag_coefficient, "1", "drag coefficient on the area",
         {.lo = 0, .hi = 10, .fallback = 0.47});
  f.choice("float.drag_law", &Float::Parameters::drag_law,
           "constant: float.drag_coefficient; sphere: the coefficient of a smooth sphere at its Reynolds "
           "number, Morrison 2013",
           {"constant", "sphere"});
  f.real("float.added_mass", &Float::Parameters::added_mass, "1",
         "added mass over the mass of the water displaced", {.lo = 0, .hi = 10, .fallback = 0.5});
  f.data("pieces", &Float::Data::pieces, "1", "number of floats at this node");
  f.term<Float::Buoyancy, netloft::conservative | netloft::symmetric | netloft::constant |
                              netloft::needs_gravity | netloft::is_weight>("buoyancy",
                                                                           "buoyancy minus weight");
  f.term<Float::Drag, netloft::reads_velocity | netloft::reads_current | netloft::needs_flow |
                          netloft::is_drag>("drag", "force of the flowing water", "float.drag_coefficient");
  f.term<Float::Inertia, netloft::symmetric | netloft::reads_acceleration | netloft::needs_motion>(
      "inertia", "mass and added mass");
  f.term<Float::Waves, netloft::symmetric | netloft::constant | netloft::reads_waves | netloft::needs_waves |
                           netloft::needs_motion>(
      "waves", "pressure of the waves on the displaced volume, and added mass of accelerated water");
  add_box(plugin);
}
