// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gear/outline.hpp"

namespace netloft::io {

/// Edges of one panel that a name stands for, in the order they are met going outwards or aft.
struct EdgeSet {
  const Panel* panel = nullptr;
  std::vector<OutlineEdge> edges;

  /// Meshes counted of the whole: to port and to starboard of a fore or aft edge in the middle.
  double meshes() const;
  /// Their twines pulled straight, of what `meshes` counts [m].
  double stretched() const;
  /// How often the whole gear has it: once across the middle, else to port and to starboard.
  int times() const;
  bool is_side() const;
  /// Whether it lies across the plane of symmetry.
  bool is_across_middle() const;
};

/// "top-wing.inner", "top-wing.breast-cut", "top-body.fore" (all stretches of it). Empty: there is no such
/// edge, and it was said at `place`, with near names; `path` is what names it. A panel without meshes has
/// none.
EdgeSet find_edge(const Plan& plan, const std::string& name, const Place& place, const std::string& path,
                  Diagnostics& diagnostics);

/// What a point belongs to: "headrope.end" to the rope, "top-wing.fore-outer" to the panel, "towing-point" to
/// itself. Empty: there is no such point, and it was said.
std::string find_point_owner(const Plan& plan, const std::string& name, const Place& place,
                             const std::string& path, Diagnostics& diagnostics);

/// How what has this name stands: a panel, a rope, a point.
Standing standing_of(const Plan& plan, const std::string& name);
/// The same of a point. Of something in the middle, what does not lie on the plane of symmetry is there
/// twice.
Standing standing_of_point(const Plan& plan, const std::string& name);
/// Whether a corner of a middle panel lies on the plane of symmetry.
bool is_corner_in_middle(const std::string& corner);

/// Corners of a panel by name: fore-outer, fore-inner, aft-outer, aft-inner, and the aft end of a cut of a
/// side of several, such as breast-cut-aft.
std::vector<std::string> corner_names(const Panel& panel);

/// `, "did you mean …"` material for hints: the nearest of `names`, or all of them.
std::string near_names(const std::string& name, const std::vector<std::string>& names);

}  // namespace netloft::io
