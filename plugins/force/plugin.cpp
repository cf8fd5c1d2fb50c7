// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/force/body_force.hpp"
#include "plugins/force/constant.hpp"

using netloft::forces::Constant;
using netloft::forces::OnBody;

NETLOFT_PLUGIN("force", "0.1.0", "Given forces") {
  const netloft::Real newtons{.lo = -1e9, .hi = 1e9, .fallback = 0};
  auto& f = plugin.element<Constant>("constant", "A constant force at a node");
  f.real("force.x", &Constant::Parameters::x, "N", "force along x", newtons);
  f.real("force.y", &Constant::Parameters::y, "N", "force along y", newtons);
  f.real("force.z", &Constant::Parameters::z, "N", "force upwards", newtons);
  f.data("pieces", &Constant::Data::pieces, "1", "number of these forces at the node");
  f.term<Constant::Pull, netloft::conservative | netloft::symmetric | netloft::constant |
                             netloft::from_outside>("pull", "the given force");

  auto& b = plugin.element<OnBody>("body", "A force on a rigid body that rotates with it");
  b.real("force.x", &OnBody::Parameters::x, "N", "force along x of the body", newtons);
  b.real("force.y", &OnBody::Parameters::y, "N", "force along y of the body, outward", newtons);
  b.real("force.z", &OnBody::Parameters::z, "N", "force along z of the body", newtons);
  b.data("side", &OnBody::Data::side, "1", "1 to starboard, -1 to port");
  b.data("arm", &OnBody::Data::arm, "m", "point of action, from the origin in the axes of the body");
  b.term<OnBody::Push>("push", "the given force and its moment");
}
