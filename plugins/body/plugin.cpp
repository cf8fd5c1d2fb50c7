// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/body/solid_element.hpp"

using namespace netloft;
using bodies::BodySolid;

NETLOFT_PLUGIN("body", "0.1.0", "Rigid bodies") {
  auto& e = plugin.element<BodySolid>("solid", "Rigid body with weight, buoyancy and drag");
  solids::declare_solid(e, "body.", {.lo = 0, .hi = 1e9, .fallback = 0});
  using P = BodySolid::Parameters;
  const Real area{.lo = 0, .hi = 1e6, .fallback = 0};
  e.real("body.drag_x", &P::drag_x, "m2", "area across its x axis, times the drag coefficient", area);
  e.real("body.drag_y", &P::drag_y, "m2", "area across its y axis, times the drag coefficient", area);
  e.real("body.drag_z", &P::drag_z, "m2", "area across its z axis, times the drag coefficient", area);
  e.real("body.damping_x", &P::damping_x, "m5",
         "resistance to turning about x: moment over half the density and "
         "the square of the spin",
         area);
  e.real("body.damping_y", &P::damping_y, "m5", "the same about y", area);
  e.real("body.damping_z", &P::damping_z, "m5", "the same about z", area);
  e.term<BodySolid::Drag, reads_velocity | reads_current | needs_flow | is_drag>(
      "drag", "force of the flowing water",
      "body.drag_x body.drag_y body.drag_z body.damping_x body.damping_y body.damping_z");
}
