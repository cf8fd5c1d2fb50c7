// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include "plugins/common/bars.hpp"
#include "plugins/priour/triangle.hpp"
#include "plugins/rope/bar.hpp"

namespace netloft::femnet {

/// What FEMNET leaves away above the surface of the water, z = 0. Each node of an element counts as a cube of
/// side h, of which the part below the surface is wet:
///   h³ = V/N,  w = clamp((h/2 − z)/h, 0, 1)                       (1)
///   r_p = −(1 − w_p) r_p^drag                                     (2)
///   r_p = (1 − w_p) (V/N) ρ_w g e_z   of bars, not of netting     (3)
/// V [m³] volume of the element's twines or rope, N its nodes, r^drag the residual of the shipped drag. Added
/// to shipped elements, which know no surface, it makes them FEMNET's. Source: the partial immersion of bars
/// and netting in FEMNET (D. Priour).
struct Cube {
  double side;  // h [m]
  double dry(double z) const { return side > 0 ? std::clamp(0.5 + z / side, 0.0, 1.0) : 0; }
  /// d(1 − w)/dz.
  double slope(double z) const { return 2 * std::abs(z) < side ? 1 / side : 0; }
  /// Integral of 1 − w up to z.
  double dry_height(double z) const {
    const double emerged = std::clamp(z + 0.5 * side, 0.0, side);
    return side > 0 ? 0.5 * emerged * emerged / side + std::max(z - 0.5 * side, 0.0) : 0;
  }
};

/// (2) of netting, an element beside priour/triangle.
struct DryNettingDrag {
  static Status tile(const Family<priour::Triangle>& family, netloft_tile& t);
};

/// (2) and (3) of ropes, an element beside rope/bar.
struct DryBarDrag {
  static Status tile(const Family<rope::Bar>& family, netloft_tile& t);
};
struct DryBarBuoyancy {
  static Status tile(const Family<rope::Bar>& family, netloft_tile& t);
};

}  // namespace netloft::femnet
