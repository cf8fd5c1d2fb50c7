// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/float/float.hpp"

using netloft::floats::Float;

NETLOFT_PLUGIN("float", "0.1.0", "Floats and weights at nodes") {
  auto& f =
      plugin.element<Float>("float", "Floats at a node or along a rope; weights have negative buoyancy");
  f.real("float.buoyancy", &Float::Parameters::buoyancy, "N",
         "net upward force of one float in water; 0: from volume and mass",
         {.lo = -1e7, .hi = 1e7, .fallback = 0});
  f.real("float.volume", &Float::Parameters::volume, "m3", "volume of one float",
         {.lo = 0, .hi = 1e3, .fallback = 0});
  f.real("float.mass", &Float::Parameters::mass, "kg", "mass of one float",
         {.lo = 0, .hi = 1e6, .fallback = 0});
  f.real("float.diameter", &Float::Parameters::diameter, "m", "diameter across the flow",
         {.lo = 0, .hi = 20, .fallback = 0});
  f.real("float.area", &Float::Parameters::area, "m2", "area across the flow; 0: of a circle of the diameter",
         {.lo = 0, .hi = 1e3, .fallback = 0});
  f.real("float.drag_coefficient", &Float::Parameters::drag_coefficient, "1", "drag coefficient on the area",
         {.lo = 0, .hi = 10, .fallback = 0.47});
  f.choice(
      "float.drag_law", &Float::Parameters::drag_law,
      "sphere: instead of drag_coefficient, that of a smooth sphere over its Reynolds number, Morrison 2013",
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
}
