// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"

namespace netloft::gears {

/// A point of a panel in repose: x meshes across, outwards; y meshes aft of the fore edge. A mesh is its full
/// width across and its stretched length aft, in agreement with mesh counts.
struct PanelPoint {
  double x = 0, y = 0;
};

enum class EdgeKind { fore, aft, outer, inner, middle };

/// One named stretch of a panel's border.
struct OutlineEdge {
  std::string name;
  EdgeKind kind;
  PanelPoint from, to;
  double meshes = 0;         // counted meshes: across for fore and aft edges, deep for sides
  double stretched = 0;      // length of its straight twines, in stretched meshes of two bars
  bool is_on_plane = false;  // in half a gear: sewn to its mirror image
};

/// The border of a panel with its corners, closed: fore edge outwards, outer side aft, aft edge inwards,
/// inner side (or the middle) forward. Edges without extent are left out, so that a panel has three corners
/// or more.
///
/// Middle panels are given by their starboard half, the middle at x = 0; pairs by the one whose inner side
/// begins at x = 0. If cuttings and counts differ (the check reports it), counts are kept, because counted
/// meshes are sewn: sides are moved by the difference, half of it each, in proportion to the depth. Then they
/// are moved inwards by the meshes that selvedges gather.
struct Outline {
  std::vector<OutlineEdge> edges;
  std::vector<PanelPoint> corners() const;
};

Outline outline_of(const Panel& panel);

/// Meshes of the aft edge of the whole panel that follow from its cuttings. Used by outlines and checks.
double aft_by_cuttings(const Panel& panel);

}  // namespace netloft::gears
