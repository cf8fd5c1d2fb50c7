// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/outline.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace netloft::gears {

/// The part of a gear that is modelled.
enum class Extent {
  whole,
  half,  // the starboard half of a symmetric gear in a symmetric flow; the middles of panels are on
         // the plane of symmetry, and so are edges sewn to their mirror image
};

/// One piece of netting of a gear. In a whole gear, panels of pairs are named "port-…" and "starboard-…", and
/// so are the edges of middle panels that exist twice; all other names are those of the plan.
struct GearPanel {
  std::string name;
  const Panel* panel = nullptr;
  bool is_mirrored = false;  // whether positive x of its outline points to port
  Outline outline;           // for a middle panel of a whole gear: both halves, port at negative x

  /// Coordinates (u, v) of a point of the outline along the two twine directions [bars].
  std::array<double, 2> twine_coordinates(PanelPoint point) const {
    return panel->twines_at(point.x, point.y);
  }

  bool has_sketch() const { return !panel->sketch.empty(); }
  /// The position [m] of a point of the outline in the initial shape, interpolated between the four corners
  /// in the plan (Panel::sketch).
  std::array<double, 3> sketched(PanelPoint point) const;
};

/// An edge of a panel: the index of the panel in Gear::panels, and that of the edge in its outline.
struct EdgeRef {
  std::size_t panel = 0, edge = 0;
  bool operator==(const EdgeRef&) const = default;
};

/// Edges that are sewn together, one or more on each side of the seam. Both sides become one line of knots,
/// however they are divided. Edges have the directions of their outlines, which may be opposite across the
/// seam. If more than two layers of netting meet in a line, each further layer is a seam with the first side.
struct Seam {
  std::array<std::vector<EdgeRef>, 2> edges;
  /// Whether edges are sewn to their mirror image; edges that cross the middle then belong to both sides of
  /// the seam.
  bool is_to_itself = false;
  bool is_of_layer = false;  // whether the second side is one more layer, beside the first two of the join
  std::size_t join = 0;      // index in NetPlan::joins
};

/// An edge hung on a rope, and the length of rope that it takes [m].
struct HungEdge {
  EdgeRef edge;
  double length = 0;
};

/// One rope of a gear. In a whole gear, a rope across the middle runs from port ("start") to starboard
/// ("end"); in half a gear it starts on the plane of symmetry and has half its length.
struct GearRope {
  std::string name;
  const Rope* rope = nullptr;
  bool is_mirrored = false;
  double length = 0;                   // unstretched length [m]
  std::vector<HungEdge> hung;          // edges from its start to its end
  std::array<std::string, 2> between;  // points at the ends of the rope, by their names in this gear
  std::string middle;  // point tied to its middle, if it lies across the middle of a whole gear
};

/// Floats, weights or pieces of ground gear in one place: along a rope, along edges, or at a point. Only one
/// of `rope`, `edges` and `point` is set.
struct GearPieces {
  std::string name;
  const Pieces* pieces = nullptr;
  double number = 0;  // number in the modelled part; half a gear has half of the pieces across the plane
  std::string rope;   // distributed along this rope
  std::vector<EdgeRef> edges;  // distributed along these edges in proportion to the length of their twines
  std::string point;           // all pieces are at this point
};

/// A point of the plan that is not the end of a rope or the corner of a panel.
struct GearPoint {
  std::string name;
  const Point* point = nullptr;
  bool is_mirrored = false;                 // whether it is the point to port of a pair
  std::optional<std::array<double, 3>> at;  // [m], mirrored if it is to port
};

/// The position of a point, or of its mirror image, if the plan gives it [m].
std::optional<std::array<double, 3>> position(const Point& point, bool is_mirrored);

/// A rigid body of the plan; its points are points of the gear.
struct GearBody {
  std::string name;
  const PlanBody* body = nullptr;
  bool is_mirrored = false;
};

/// The modelled parts of a net plan, including those mirrored to port. The gear refers to the plan, which
/// must outlive it. Points have names such as "headrope.end", "port-wing.fore-outer" and "port-towing-point".
/// In a whole gear, corners of middle panels are named like their edges, "body.port-fore-outer"; corners on
/// the plane of symmetry have names such as "body.fore-inner".
struct Gear {
  Extent extent = Extent::whole;
  std::vector<GearPanel> panels;
  std::vector<Seam> seams;
  std::vector<GearRope> ropes;
  std::vector<GearPieces> pieces;
  std::vector<GearPoint> points;
  std::vector<GearBody> bodies;

  const GearPanel* find_panel(const std::string& name) const;
  const GearRope* find_rope(const std::string& name) const;
  /// Returns the name of an edge, such as "top-body.port-wing".
  std::string name_of(const EdgeRef& edge) const;
  /// If a row of edges goes round the net, returns the last panel of the row, otherwise nullopt. Such a row
  /// begins in the middle of its first panel, goes outwards, and comes back to the middle along its last
  /// panel (for example, the upper and the lower panel before a tube).
  std::optional<std::size_t> last_of_ring(const std::vector<EdgeRef>& row) const;

 private:
  mutable formats::NameIndex panel_names_, rope_names_;
};

/// Makes the gear of a plan without errors (check.hpp).
Gear make_gear(const NetPlan& plan, Extent extent);
/// Makes only the ropes and points of the whole gear, without edges hung on ropes.
Gear make_rigging(const NetPlan& plan);

}  // namespace netloft::gears
