// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/gear.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::gears {

namespace {

using Place3 = std::array<double, 3>;

double between(double a, double b, double t) { return a + t * (b - a); }

Place3 between(const Place3& a, const Place3& b, double t) {
  return {between(a[0], b[0], t), between(a[1], b[1], t), between(a[2], b[2], t)};
}

/// The positions of the ends of the sides of a panel, in meshes across.
struct SideEnds {
  double fore_inner = 0, fore_outer = 0, aft_outer = 0, aft_inner = 0;
};

SideEnds side_ends(const Outline& outline) {
  SideEnds ends;
  bool outer_seen = false, inner_seen = false;
  for (const auto& edge : outline.edges) {
    if (edge.kind == EdgeKind::outer) {
      if (!outer_seen) ends.fore_outer = edge.from.x;
      ends.aft_outer = edge.to.x;
      outer_seen = true;
    } else if (edge.kind == EdgeKind::inner || edge.kind == EdgeKind::middle) {
      if (!inner_seen) ends.aft_inner = edge.from.x;
      ends.fore_inner = edge.to.x;
      inner_seen = true;
    }
  }
  return ends;
}

/// Converts a point at x meshes across, at the fraction t of the depth, to a fraction across the panel: 0 on
/// the inner side, 1 on the outer side. Both sides are taken as straight. At a point where they meet, the
/// result is 0.
double fraction_across(const SideEnds& ends, double x, double t) {
  const double inner = between(ends.fore_inner, ends.aft_inner, t),
               outer = between(ends.fore_outer, ends.aft_outer, t);
  return outer - inner > 1e-9 ? (x - inner) / (outer - inner) : 0;
}

}  // namespace

std::array<double, 3> GearPanel::sketched(PanelPoint point) const {
  const auto& corner = panel->sketch;
  const bool is_middle = panel->stands == Standing::middle,
             is_port = is_mirrored || (is_middle && point.x < 0);
  const double t = point.y / panel->depth;
  const double s = fraction_across(side_ends(panel->outline), is_middle ? std::abs(point.x) : point.x, t);
  Place3 at = between(between(corner[0], corner[1], s), between(corner[3], corner[2], s), t);
  if (is_port) at[1] = -at[1];
  return at;
}

}  // namespace netloft::gears
