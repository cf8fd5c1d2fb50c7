// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hydro/reynolds.hpp"

namespace netloft::hydro {

namespace {

/// Computes the force of all flows of a tile, with k and g of reynolds.hpp (4). `phi` is the function φ(Re).
template <class Phi>
void lanes_with(const MorisonReynolds::Parameters& p, const netloft_law_tile& f, const Phi& phi) {
  const double half = 0.5 * f.water_density * f.water_viscosity, per_viscosity = 1 / f.water_viscosity;
  const double* diameter = f.diameter;
  cross_flow_lanes({p.shielding, p.tangential}, f, [=](std::size_t i, double s) {
    const auto at = phi(LaneNumber::variable(s * diameter[i] * per_viscosity));
    return Resistance{half * at.value, half * at.slope};
  });
}

}  // namespace

void MorisonReynolds::lanes(const Parameters& p, const netloft_law_tile& f) {
  if (!(f.water_viscosity > 0))
    throw std::runtime_error(
        "morison-reynolds needs a viscosity of the water above zero, for its Reynolds number");
  with_phi(p, [&](const auto& phi) { lanes_with(p, f, phi); });
}

}  // namespace netloft::hydro
