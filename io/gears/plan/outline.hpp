// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"

namespace netloft::gears {

/// A point of an undeformed panel: x meshes across, outwards; y meshes aft of the fore edge. In both
/// directions, the unit is a mesh as net makers count it.
struct PanelPoint {
  double x = 0, y = 0;
};

enum class EdgeKind { fore, aft, outer, inner, middle };

/// One named stretch of a panel's border.
struct OutlineEdge {
  std::string name;
  EdgeKind kind;
  PanelPoint from, to;
  double meshes = 0;         // counted meshes: across along fore and aft edges, deep along sides
  double stretched = 0;      // length of its straight twines, in stretched meshes of two bars
  bool is_on_plane = false;  // in half a gear: whether the edge is sewn to its mirror image
};

/// The closed border of a panel with its corners: fore edge outwards, outer side aft, aft edge inwards, inner
/// side (or the middle) forward. Edges without extent are left out, so that a panel has three corners or
/// more.
///
/// A middle panel is represented by its starboard half, with the middle at x = 0; a pair by its starboard
/// panel, whose inner side begins at x = 0. If cuttings and counts disagree, which the check reports, counts
/// are kept, because counted meshes are sewn: each side is moved by half of the difference, in proportion to
/// the depth. Then sides are moved inwards by the meshes that selvedges gather.
struct Outline {
  std::vector<OutlineEdge> edges;
  std::vector<PanelPoint> corners() const;
};

Outline outline_of(const Panel& panel);

/// The number of meshes that the cuttings give the aft edge of the whole panel.
double aft_by_cuttings(const Panel& panel);

}  // namespace netloft::gears
