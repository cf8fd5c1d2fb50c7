// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/winch.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/toml/value.hpp"
#include "io/gears/plan/cutting.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace netloft::gears {

// A net plan as written by its maker: counts in meshes, lengths in metres, names unchanged. Parts that exist
// to port and to starboard are written once; nothing is mirrored, cut to size or divided yet.

/// The symmetry of a part.
enum class Standing {
  alone,   // exists once, in its place
  pair,    // to starboard, and mirrored to port
  middle,  // across the plane, symmetric in itself
};

/// Meshes counted along a fore or an aft edge. In the lists of a panel they come from the middle outwards (of
/// a pair: from the inner side outwards); of a middle panel the first lies across the middle, whole, and each
/// of the others is there to port and to starboard.
struct MeshCount {
  std::string name;
  double meshes = 0;
  formats::Place place;
  bool operator==(const MeshCount&) const = default;
};

/// A stretch of a side that is cut at one rate, going aft.
struct Cut {
  std::string name;
  std::string written;  // "5B1P in"
  CuttingRate rate;
  bool is_known = true;  // false: the text is not a rate, and `rate` is a guess
  int goes = 0;          // +1 outwards, the panel becomes wider going aft; -1 inwards
  // meshes; if neither is given, the cut takes the rest of the depth
  std::optional<double> said_across, said_deep;
  double across = 0, deep = 0;  // meshes, as computed
  double selvedge = 0;          // meshes gathered into the seam along it
  formats::Place place;
  bool operator==(const Cut&) const = default;
};

/// Computes the extent of each cut of a side from the given numbers and the depth of the panel.
void settle(std::vector<Cut>& side, double depth);

/// An edge that a plan declares open: "fore", "aft", the name of a stretch.
struct OpenEdge {
  std::string name;
  formats::Place place;
  bool operator==(const OpenEdge&) const = default;
};

struct Panel {
  std::string name;
  Standing stands = Standing::middle;
  double mesh = 0;  // stretched mesh size, two bars [m]
  std::string orientation = "diamond";
  double angle = 0;           // rotation of the netting in the panel, twine_coordinates.hpp (2) [rad]
  std::string twine_name;     // in the catalogue; empty: written in the plan
  formats::Value twine;       // a table: diameter, EA, density, …
  double twine_diameter = 0;  // [m]
  int twines = 1;             // number laid side by side: 2 in double netting
  std::vector<MeshCount> fore, aft;
  bool states_aft = false;     // whether the plan states it; otherwise it follows from the cuttings
  double depth = 0;            // meshes, over all pieces in a row
  int pieces = 1;              // sewn in a row mesh to mesh, each `depth`/`pieces` deep
  std::vector<OpenEdge> open;  // edges that are sewn and hung nowhere on purpose
  bool has_corners = false;    // given by corners, which enclose netting, instead of counts and cuttings
  bool is_round = false;       // a tube: its sides are sewn to one another
  std::vector<Cut> outer;      // of a middle panel: both sides
  std::vector<Cut> inner;      // of a middle panel: none
  /// Initial corners: fore-inner, fore-outer, aft-outer, aft-inner, to starboard [m]; may be empty.
  std::vector<std::array<double, 3>> sketch;
  formats::Place place, aft_place;

  /// Whether it has no netting by its counts: a panel by corners may have a corner at either end.
  bool is_empty() const { return !has_corners && count(fore) <= 0 && count(aft) <= 0; }
  /// Meshes of the whole edge, to port and to starboard of a middle panel.
  double count(const std::vector<MeshCount>& edge) const;
  /// (u, v) in bars of a point, or of the vector from one point to another; twine_coordinates.hpp.
  std::array<double, 2> twines_at(double across, double deep) const;
  bool operator==(const Panel&) const = default;
};

constexpr double kWinchSpeed = 2;    // [m/s]; trawl winches haul some 80 to 120 m in a minute
constexpr double kWinchBand = 0.05;  // of the tension

/// A rope, wire or chain. One in the middle is given in full length; it starts in the middle and ends on both
/// sides.
struct Rope {
  std::string name;
  Standing stands = Standing::alone;
  std::string part_name;
  formats::Value rope;                // a table: diameter, EA, density, …
  double length = 0;                  // unstretched [m]
  std::optional<double> length_port;  // of the one to port, if it is another [m]
  // At its start, to starboard and to port, if the length is found that has it [N].
  std::optional<double> tension, tension_port;
  std::string role;  // one of rope_roles(); empty: none
  formats::Place role_place;
  std::array<std::string, 2> between;  // points at its ends; empty: none
  // How a winch runs in a motion; of one that begins with `tension` the first stage has no rows.
  std::vector<WinchStage> winch;
  formats::Place winch_place, tension_place;
  bool is_selvedge = false;  // true for meshes gathered into a seam, which plans do not write as ropes
  formats::Place place, between_place;
};

/// The roles of ropes in a gear. Reports have figures of the mouth if a headline and a footrope are named.
const std::vector<std::string>& rope_roles();

/// An edge hung on a rope. Along the rope, edges follow one another in the order of its hangings.
struct Hanging {
  std::string edge, rope;
  // length of rope that it takes, over the whole of a middle edge [m]; 0: given by the ratio
  double length = 0;
  double ratio = 0;  // length of rope divided by that of the stretched edge; 0: given by the length
  formats::Place edge_place, rope_place, place;
  bool operator==(const Hanging&) const = default;
};

/// Edges sewn together, each side one edge or several in a row. If both sides are the same edge, port is sewn
/// to starboard.
struct Join {
  std::array<std::vector<std::string>, 2> edges;
  double take_up = 0;   // meshes of the second for one of the first; 0: mesh to mesh
  double selvedge = 0;  // meshes of each edge that are gathered into the seam
  std::array<formats::Place, 2> places;
  formats::Place place;

  bool is_to_itself() const { return edges[0] == edges[1]; }
  bool operator==(const Join&) const = default;
};

/// "47 along headrope", "2 at footrope.end": floats, weights or pieces of ground gear, distributed along a
/// rope or an edge, or hung at a point.
struct Pieces {
  std::string name, part_name;
  formats::Value piece;
  double number = 0;      // in the whole gear
  std::string along, at;  // one of them is set
  formats::Place place, spread_place;

  bool is_along_edge() const { return along.find('.') != std::string::npos; }
};

/// A point that is not the end of a rope: where bridles meet, or where the gear is towed.
struct Point {
  std::string name;
  Standing stands = Standing::pair;
  std::optional<std::array<double, 3>> at;  // [m]; for a pair the one to starboard
  formats::Place place;
  bool operator==(const Point&) const = default;
};

/// A rigid body, such as an otter board. The plan contains only the points to which ropes lead, `door.warp`;
/// the scene reads the rest.
struct PlanBody {
  std::string name;
  Standing stands = Standing::pair;
  std::vector<std::string> points;  // by name; each is a point of the plan as well
  formats::Place place;
  bool operator==(const PlanBody&) const = default;
};

/// How a ship goes at a time: straight between times, and as at the last one beyond.
struct ShipMoment {
  double t;        // [s]
  double speed;    // over the ground [m/s]
  double heading;  // from where it went at the start, to starboard [rad]
};

/// The ship that tows the gear: it makes the points and the ropes `block` and `warp`.
struct Ship {
  double speed = 0;                        // over the ground [m/s]
  double block_height = 0, block_gap = 0;  // above the water, between those to port and to starboard [m]
  double efficiency = 0;                   // towing power over the heat of the fuel; 0: not known
  std::vector<ShipMoment> path;            // in a motion; empty: straight on
  std::vector<ShipMoment> path_port;       // of a second ship that tows to port; empty: there is one ship
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
};

}  // namespace netloft::gears
