// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hydro/reynolds.hpp"

namespace netloft::hydro {

void MorisonReynolds::lanes(const Parameters& p, const netloft_flow& f) {
  const double nu = f.water_viscosity;
  if (!(nu > 0)) throw std::runtime_error("a Reynolds number needs a viscosity of the water above zero");
  cross_flow_lanes({p.shielding, p.tangential}, f, [&](std::size_t i, double s) {
    const double Re = s * f.diameter[i] / nu;
    const auto at = phi(p, Dual<1, 1>::variable(Re, 0));
    const double half = 0.5 * f.water_density * nu;
    return Resistance{half * at.value, half * Re * at.gradient[0]};  // (4)
  });
}

}  // namespace netloft::hydro
