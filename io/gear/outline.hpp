// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gear/plan.hpp"

namespace netloft::io {

/// A point of a panel in repose: x meshes across, outwards; y meshes aft of the fore edge. A mesh stands for
/// its full width across and its stretched length aft, as counts are counted.
struct PanelPoint {
  double x = 0, y = 0;
};

enum class EdgeKind { fore, aft, outer, inner, middle };

/// One named stretch of a panel's border.
struct OutlineEdge {
  std::string name;
  EdgeKind kind;
  PanelPoint from, to;
  double meshes = 0;     // as counted: across of fore and aft edges, deep of sides
  double stretched = 0;  // length of its twines pulled straight, in stretched meshes of two bars
};

/// The border of a panel with its corners, closed: fore edge outwards, outer side aft, aft edge inwards,
/// inner side (or the middle) forward. Edges without extent are left out, so that a panel has three corners
/// or more.
///
/// Middle panels are given by their starboard half, the middle at x = 0; pairs by the one whose inner side
/// begins at x = 0. Where cuttings and counts differ (the check speaks of that), counts are kept, for they
/// are what is sewn: sides are moved by the difference, half of it each, in proportion to the depth. Then
/// they are moved inwards by what selvedges gather of them.
struct Outline {
  std::vector<OutlineEdge> edges;
  std::vector<PanelPoint> corners() const;
};

Outline outline_of(const Panel& panel);

/// Meshes of the aft edge as its cuttings give them, the whole panel. Both outlines and checks need it.
double aft_by_cuttings(const Panel& panel);

}  // namespace netloft::io
