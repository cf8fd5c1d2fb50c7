// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/force/constant.hpp"

using netloft::forces::Constant;

NETLOFT_PLUGIN("force", "0.1.0", "Forces that are given") {
  auto& f = plugin.element<Constant>("constant", "A force at a node that does not change");
  const netloft::Real newtons{.lo = -1e9, .hi = 1e9, .fallback = 0};
  f.real("force.x", &Constant::Parameters::x, "N", "force along x", newtons);
  f.real("force.y", &Constant::Parameters::y, "N", "force along y", newtons);
  f.real("force.z", &Constant::Parameters::z, "N", "force upwards", newtons);
  f.data("pieces", &Constant::Data::pieces, "1", "number of these forces at the node");
  f.term<Constant::Pull, netloft::conservative | netloft::symmetric | netloft::constant |
                             netloft::from_outside>("pull", "the force that is given");
}
