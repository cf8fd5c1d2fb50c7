// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/hydro/morison.hpp"

namespace netloft::hydro {

void Morison::lanes(const Parameters& p, const netloft_law_tile& f) {
  const double half = 0.5 * f.water_density * p.normal;
  const double* diameter = f.diameter;
  cross_flow_lanes({p.shielding, p.tangential}, f, [half, diameter](std::size_t i, double s) {
    const double k = half * diameter[i] * s;  // (1)
    return Resistance{k, k};
  });
}

}  // namespace netloft::hydro
