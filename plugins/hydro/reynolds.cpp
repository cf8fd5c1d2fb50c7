// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hydro/reynolds.hpp"

namespace netloft::hydro {

namespace {

/// (4) for φ of a Reynolds number.
template <class Phi>
void lanes_with(const MorisonReynolds::Parameters& p, const netloft_flow& f, Phi&& phi) {
  const double half = 0.5 * f.water_density * f.water_viscosity, per_viscosity = 1 / f.water_viscosity;
  const double* diameter = f.diameter;
  cross_flow_lanes({p.shielding, p.tangential}, f, [=](std::size_t i, double s) {
    const auto at = phi(LaneNumber::variable(s * diameter[i] * per_viscosity));
    return Resistance{half * at.value, half * at.slope};
  });
}

}  // namespace

void MorisonReynolds::lanes(const Parameters& p, const netloft_flow& f) {
  if (!(f.water_viscosity > 0))
    throw std::runtime_error("a Reynolds number needs a viscosity of the water above zero");
  if (p.normal.rows)
    lanes_with(p, f, [curve = Curve(p.normal)](const LaneNumber& Re) { return Re * curve.at(Re); });
  else if (p.cylinder == static_cast<std::int64_t>(Cylinder::takagi))
    lanes_with(p, f, [](const LaneNumber& Re) { return takagi_phi(Re); });
  else
    lanes_with(p, f, [](const LaneNumber& Re) { return choo_casarella_phi(Re); });
}

}  // namespace netloft::hydro
