// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/outline.hpp"

#include <map>

namespace netloft::gears {

/// The edges of one panel that a name means, ordered from the middle outwards, or aft.
struct EdgeSet {
  const Panel* panel = nullptr;
  std::vector<OutlineEdge> edges;

  /// Number of meshes. For a fore or aft edge across the middle, it includes port and starboard.
  double meshes() const;
  /// Length of the straight twines along the edges [m], counted like meshes().
  double stretched() const;
  /// How often the edges exist in the whole gear: once if they lie across the middle or in a single panel,
  /// otherwise twice.
  int times() const;
  bool is_side() const;
  /// Whether the edges lie across the plane of symmetry.
  bool is_across_middle() const;
};

/// The edges that a name means, such as "top-wing.inner", "top-wing.breast-cut" or "top-body.fore" (all parts
/// of the fore edge). If there is no such edge, returns an empty set and reports an error at `place` with
/// similar names; `path` is the key that contains the name. A panel without meshes has no edges.
EdgeSet find_edge(const NetPlan& plan, const std::string& name, const formats::Place& place,
                  const std::string& path, formats::Diagnostics& diagnostics);

/// The hangings of a plan, by the name of the rope. The hangings of one rope keep the order of the plan.
using HangingsByRope = std::multimap<std::string, const Hanging*>;
HangingsByRope hangings_by_rope(const NetPlan& plan);

/// The rope of this name. If there is none, reports an error and returns nullptr.
const Rope* find_rope_or_say(const NetPlan& plan, const std::string& name, const formats::Place& place,
                             const std::string& path, formats::Diagnostics& diagnostics);

/// The owner of a point: "headrope.end" belongs to the rope, "top-wing.fore-outer" to the panel,
/// "towing-point" to itself. If there is no such point, reports an error and returns an empty text.
std::string find_point_owner(const NetPlan& plan, const std::string& name, const formats::Place& place,
                             const std::string& path, formats::Diagnostics& diagnostics);

/// The symmetry of the panel, rope or point of this name.
Standing standing_of(const NetPlan& plan, const std::string& name);
/// The symmetry of a point. Points of middle parts exist twice unless they lie on the plane of symmetry.
Standing standing_of_point(const NetPlan& plan, const std::string& name);
/// Whether a body in the middle has a point of this name on both sides: `beam.end` means its points
/// `port-end` and `starboard-end`.
bool is_on_both_sides(const NetPlan& plan, const std::string& name);
/// Whether a corner of a middle panel lies on the plane of symmetry.
bool is_corner_in_middle(const std::string& corner);

/// The names of the corners of a panel: fore-outer, fore-inner, aft-outer, aft-inner, and, for a side with
/// several cuts, the aft ends of the cuts, such as breast-cut-aft.
std::vector<std::string> corner_names(const Panel& panel);

}  // namespace netloft::gears
