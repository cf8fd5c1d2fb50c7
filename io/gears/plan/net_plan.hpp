// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/winch.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/toml/name_index.hpp"
#include "io/formats/toml/value.hpp"
#include "io/gears/plan/cutting.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace netloft::gears {

// A net plan as written by its maker: counts in meshes, lengths in metres, names unchanged. Parts that exist
// to port and to starboard are stored once: nothing is mirrored or divided into elements yet.

/// The symmetry of a part.
enum class Standing {
  alone,   // exists once, anywhere
  pair,    // exists to starboard, and mirrored to port
  middle,  // lies across the plane of symmetry, and is symmetric itself
};

/// A number of meshes along a fore or an aft edge. A panel lists its counts from the middle outwards (in a
/// pair: from the inner side outwards). In a middle panel, the first count covers the whole stretch across
/// the middle; each of the other counts exists to port and to starboard.
struct MeshCount {
  std::string name;
  double meshes = 0;
  formats::Place place;
  bool operator==(const MeshCount&) const = default;
};

/// A stretch of one side of a panel that is cut at one rate. The cuts of a side are listed from fore to aft.
struct Cut {
  std::string name;
  std::string written;  // rate and direction as written, such as "5B1P in"
  CuttingRate rate;
  bool is_known = true;  // false: the text is not a rate, and `rate` is a guess
  int goes = 0;          // +1: the panel becomes wider towards its aft edge, -1: narrower, 0: constant width
  // Numbers of meshes as written in the plan; a cut without both takes the rest of the panel's depth.
  std::optional<double> said_across, said_deep;
  double across = 0, deep = 0;  // numbers of meshes, computed
  double selvedge = 0;          // meshes that are gathered into the seam along the cut
  formats::Place place;
  bool operator==(const Cut&) const = default;
};

/// Computes the extent of each cut of a side from the given numbers and the depth of the panel.
void settle(std::vector<Cut>& side, double depth);

/// An edge that a plan declares open, by its name: "fore", "aft", or the name of a stretch.
struct OpenEdge {
  std::string name;
  formats::Place place;
  bool operator==(const OpenEdge&) const = default;
};

/// A point of an undeformed panel: x meshes across, outwards; y meshes aft of the fore edge. In both
/// directions, meshes are counted as net makers count them.
struct PanelPoint {
  double x = 0, y = 0;
  bool operator==(const PanelPoint&) const = default;
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
  bool operator==(const OutlineEdge&) const = default;
};

/// The closed border of a panel with its corners: fore edge outwards, outer side aft, aft edge inwards, inner
/// side (or the middle) forward. Edges without extent are left out, so that a panel has three corners or
/// more.
///
/// A middle panel is represented by its starboard half, with the middle at x = 0; a pair by its starboard
/// panel, whose inner side begins at x = 0. If cuttings and counts disagree (the check reports this), the
/// counts are kept, because seams join counted meshes: each side is moved by half of the difference, in
/// proportion to the depth. Then the sides are moved inwards by the meshes that seams gather.
struct Outline {
  std::vector<OutlineEdge> edges;
  std::vector<PanelPoint> corners() const;
  bool operator==(const Outline&) const = default;
};

struct Panel {
  std::string name;
  Standing stands = Standing::middle;
  double mesh = 0;  // stretched mesh size, two bars [m]
  std::string orientation = "diamond";
  double angle = 0;           // rotation of the netting in the panel, from outwards towards aft [rad]
  std::string twine_name;     // name in the catalogue; empty if the plan states the numbers
  formats::Value twine;       // a table of the properties of the twine: diameter, EA, density, …
  double twine_diameter = 0;  // [m]
  int twines = 1;             // number of twines side by side: 2 in double netting
  std::vector<MeshCount> fore, aft;
  bool states_aft = false;     // whether the plan states the aft count; otherwise the cuttings give it
  double depth = 0;            // meshes from fore to aft, over all pieces in a row
  int pieces = 1;              // number of pieces sewn mesh to mesh in a row, each `depth`/`pieces` deep
  std::vector<OpenEdge> open;  // edges that are intentionally neither sewn nor hung
  bool has_corners = false;    // whether the panel is given by its corners instead of counts and cuttings
  bool is_round = false;       // whether the panel is a tube: its sides are sewn together
  std::vector<Cut> outer;      // outer side; both sides of a middle panel
  std::vector<Cut> inner;      // inner side; empty in a middle panel
  Outline outline;             // computed by outline_of() from counts, cuttings and depth
  /// Initial corners of a starboard panel, or of the starboard half of a middle panel [m]: fore-inner,
  /// fore-outer, aft-outer, aft-inner; may be empty.
  std::vector<std::array<double, 3>> sketch;
  formats::Place place, aft_place;

  /// Whether both counts are zero, so that there is no netting. A panel given by corners is never empty: its
  /// ends may be points.
  bool is_empty() const { return !has_corners && count(fore) <= 0 && count(aft) <= 0; }
  /// Meshes of the whole edge; for a middle panel, port and starboard together.
  double count(const std::vector<MeshCount>& edge) const;
  /// Coordinates (u, v) of a point along the two twine directions [bars]; also of a vector between two
  /// points.
  std::array<double, 2> twines_at(double across, double deep) const;
  bool operator==(const Panel&) const = default;
};

constexpr double kWinchSpeed = 2;    // [m/s]; trawl winches haul some 80 to 120 m in a minute
constexpr double kWinchBand = 0.05;  // default deviation at full speed, as a fraction of the tension

/// A rope, wire or chain. A rope in the middle starts on the plane of symmetry and ends on both sides; its
/// length here is the full length.
struct Rope {
  std::string name;
  Standing stands = Standing::alone;
  std::string part_name;
  formats::Value rope;                // a table of the properties of the rope: diameter, EA, density, …
  double length = 0;                  // unstretched length [m]
  std::optional<double> length_port;  // length of the rope to port, if different [m]
  // The required tension at the start of the rope, to starboard and to port [N], if the solver finds its
  // length.
  std::optional<double> tension, tension_port;
  std::string role;  // one of rope_roles(); empty: none
  formats::Place role_place;
  std::array<std::string, 2> between;  // points at its ends; empty if an end is not tied
  // Control of the winch during a motion, stage by stage. A first stage without rows keeps the tension at
  // `tension`.
  std::vector<WinchStage> winch;
  formats::Place winch_place, tension_place;
  bool is_selvedge =
      false;  // whether this is a strip of meshes gathered into a seam, which is no rope of the plan
  formats::Place place, between_place;
};

/// The roles that a rope may have in a gear. Reports describe the mouth of the net if one rope is the
/// headline and another the footrope.
const std::vector<std::string>& rope_roles();

/// An edge that is hung on a rope. The edges of a rope follow each other in the order of the hangings.
struct Hanging {
  std::string edge, rope;
  // Length of rope that the edge takes [m]; for an edge across the middle, the length for both halves. 0 if
  // `ratio` is given.
  double length = 0;
  double ratio = 0;  // length of rope divided by that of the stretched edge; 0 if `length` is given
  formats::Place edge_place, rope_place, place;
  std::string path = {};  // path of its table, "hang[2]"; empty if no table states it
  bool operator==(const Hanging&) const = default;
};

/// Rows of one or more edges that are sewn together: two sides of a net, and further layers of netting that
/// are sewn to the same line, such as a funnel or a cover. If there are two rows of the same edges, port is
/// sewn to starboard.
struct Join {
  std::vector<std::vector<std::string>> edges;  // two rows or more
  std::vector<double> take_up =
      {};               // for each row after the first, meshes per mesh of the first; 0: mesh to mesh
  double selvedge = 0;  // meshes of each edge that are gathered into the seam
  std::vector<formats::Place> places;
  formats::Place place;
  std::string path = {};  // path of its table, "join[2]"; empty if no table states it

  bool is_to_itself() const { return edges.size() == 2 && edges[0] == edges[1]; }
  double take_up_of(std::size_t row) const { return row <= take_up.size() ? take_up[row - 1] : 0; }
  bool operator==(const Join&) const = default;
};

/// Floats, weights or pieces of ground gear that are distributed along a rope or an edge, or hung at a point:
/// "47 along headrope", "2 at footrope.end".
struct Pieces {
  std::string name, part_name;
  formats::Value piece;
  double number = 0;        // pieces in the whole gear
  bool has_number = false;  // whether its key `number` says how many, and not `spread`
  std::string along, at;    // exactly one of them is set
  formats::Place place, spread_place;

  bool is_along_edge() const { return along.find('.') != std::string::npos; }
};

/// A point that is not the end of a rope: where bridles meet, or where the gear is towed.
struct Point {
  std::string name;
  Standing stands = Standing::pair;
  std::optional<std::array<double, 3>> at;  // position [m]; for a pair, that of the starboard point
  formats::Place place;
  bool operator==(const Point&) const = default;
};

/// A point of a rigid body to which ropes lead; it is also a point of the plan, body.name.
struct BodyPoint {
  std::string name;
  double y = 0;  // position in the axes of the body, to starboard [m]; 0 if the point has errors, which the
                 // scene reports
  bool operator==(const BodyPoint&) const = default;
};

/// A rigid body, such as an otter board. The plan contains only its points, such as `door.warp`, to which
/// ropes lead, and the edge on its rim; the scene reads the rest.
struct PlanBody {
  std::string name;
  Standing stands = Standing::pair;
  std::vector<BodyPoint> points;
  formats::Place place;
  std::string rim = {};  // the edge of a panel that is hung on its rim; empty: none
  formats::Place rim_place = {};
  bool operator==(const PlanBody&) const = default;

  const BodyPoint* find_point(const std::string& point) const;
};

/// Speed and heading of a ship at a time. Both are linear between the times and constant after the last one.
struct ShipMoment {
  double t;        // [s]
  double speed;    // speed over the ground [m/s]
  double heading;  // heading relative to the initial one, positive to starboard [rad]
};

/// The ship that tows the gear. Reading it adds the points `block` and the ropes `warp` to the plan.
struct Ship {
  double speed = 0;                        // speed over the ground [m/s]
  double block_height = 0, block_gap = 0;  // height above the water; distance between the port and the
                                           // starboard block [m]
  double efficiency = 0;                   // towing power divided by the heat power of the fuel; 0: unknown
  std::vector<ShipMoment> path;            // path in a motion; empty: constant speed, straight ahead
  std::vector<ShipMoment> path_port;       // path of a second ship, to port; empty if there is only one ship
  formats::Place place, speed_place, path_place;
};

inline constexpr const char *kBlock = "block", *kWarp = "warp";

struct NetPlan {
  std::string title, source;
  std::vector<Panel> panels;
  std::vector<Rope> ropes;
  std::vector<Hanging> hangings;
  std::vector<Join> joins;
  std::vector<Pieces> pieces;
  std::vector<Point> points;
  std::vector<PlanBody> bodies;
  std::optional<Ship> ship;
  std::vector<formats::SourceFile> files;

  const Panel* find_panel(const std::string& name) const;
  const Rope* find_rope(const std::string& name) const;
  const Point* find_point(const std::string& name) const;
  const PlanBody* find_body(const std::string& name) const;

 private:
  mutable formats::NameIndex panel_names_, rope_names_, point_names_, body_names_;
};

}  // namespace netloft::gears
