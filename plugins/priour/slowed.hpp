// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/priour/twines.hpp"

namespace netloft::priour {

/// Water that a catch slows ahead of its front, along the flow:
///   d = ξ − e·x̄,  e = (cos ψ, sin ψ, 0)                 distance ahead of the front             (1)
///   s = 1 − b (1 + d²/R²)^(−3/2)  if d > 0, else 1 − b    fraction of the velocity that remains   (2)
///   ∂s/∂x̄ = −3 b d/R² (1 + d²/R²)^(−5/2) e               continuous at d = 0                     (3)
/// x̄ [m] is the centroid of a triangle, ξ [m] the position of the front along the flow, ψ [rad] the
/// direction of the flow, b [1] the fraction of the velocity that is lost at the front, R [m] the radius of
/// the catch. The lost velocity in (2) decreases along the axis like the velocity that a vortex ring at the
/// rim of the front induces (H. Lamb, Hydrodynamics, art. 161), and like the flow ahead of a sphere. (2)
/// applies to the whole cod-end, whose netting is near the axis. If the catch is given by its volume, ξ is
/// the front that was computed for that volume.
struct Slowing {
  bool acts = false;
  double left[kLanes], x[kLanes], y[kLanes];  // s; (3) along x and y [1/m]

  Slowing(const Triangle::Lanes& p, const netloft_tile& t, std::uint32_t kind_of_law);
};

/// The change of the drag of netting in slowed water: the drag of drag.hpp at the velocity s c of the water,
/// minus that at the undisturbed velocity c.
struct SlowedDrag {
  static Status tile(const Family<Triangle>& family, netloft_tile& t);
};

}  // namespace netloft::priour
