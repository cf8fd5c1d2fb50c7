// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/hydro/crossflow.hpp"

namespace netloft::hydro {

/// Drag of twines, ropes and wires with constant coefficients: crossflow.hpp (1)–(5) with
///   k = ½ ρ D C_n s,  g = k                                             (1)
/// so that F = ½ ρ D [C_n ‖U_n‖ U_n + C_t |τ| τ t] per metre; C_n and C_t are the coefficients for the flow
/// across and along the twine. Source: the trawl-gear paper, eqs. (2) and (4); Morison et al. 1950 for the
/// drag of a cylinder. For netting, it over-predicts the drag at small angles of attack, because twines are
/// then in the wake of other twines.
struct Morison {
  static constexpr auto kind = NETLOFT_TWINE_LAW;
  struct Parameters {
    double normal = 0, tangential = 0, shielding = 0;
  };
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    const double half = 0.5 * f.density * f.diameter * p.normal;
    return cross_flow_force(CrossFlow{p.shielding, p.tangential}, f,
                            [half](const T& s) { return T(half) * s; });
  }
  static void lanes(const Parameters& p, const netloft_law_tile& f);
};

}  // namespace netloft::hydro
