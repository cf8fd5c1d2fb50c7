// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/static_problem.hpp"
#include "framework/scene/scene.hpp"
#include "framework/scene/scene_plan.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/toml/name_index.hpp"
#include "io/scenes/reading/dynamics.hpp"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace netloft::gears {
class Division;
}

namespace netloft::scenes {

/// A part as the author of the scene sees it: its nodes, by their numbers within the part ("own" numbers,
/// from 0), and the names of its edges and corners.
struct PartGeometry {
  std::string name;
  formats::Place place;
  std::vector<std::uint32_t> nodes;  // indexed by own number: number of the node in the scene
  std::vector<int> cells;  // number of bars of a rope; cells across and along a panel; empty for others
  std::vector<std::array<double, 2>> panel;  // indexed by own number: (U, V) [meshes]; empty: no panel
  std::map<std::string, std::vector<std::uint32_t>> sets;  // own numbers along edges, by name
  bool is_numbered = false;  // whether a hold, a join or an `on` names a node of this part by number
};

/// The nodes and axes of a `[[hold]]`. The reaction of the hold is reported under its name.
struct Hold {
  std::string name;
  std::vector<std::uint32_t> nodes;  // numbers of nodes in the scene
  std::vector<std::uint8_t> axes;    // for each node, the axes whose reactions count for this hold
  bool is_loose = false;             // whether the hold only prevents drift, and bears nothing in equilibrium
};

/// One line of `[results]`: a number that the scene requests, such as the lowest z of the net.
struct ResultRequest {
  enum class Source { position, displacement, reaction, attitude, output };
  std::string name, of, take;
  std::string how;       // min, max, mean, sum, range
  std::string quantity;  // such as "z" or "tension"
  std::string unit, doc;
  Source source = Source::position;
  // 0, 1, 2: x, y, z; 3: length of the vector. For an attitude, 0: heading, 1: heel, 2: trim.
  int axis = 0;
  std::uint32_t body = 0;            // index in Scene::bodies, for attitudes
  std::vector<std::uint32_t> nodes;  // numbers of nodes in the scene
  std::uint32_t part = 0;            // index in Scene::parts, for outputs
};

/// The table `[analysis]`: how the scene is solved.
struct Analysis {
  AnalysisKind kind = AnalysisKind::statics;
  bool settles = false;  // whether `solver` is an integrator, whose damped motion finds the equilibrium
  Dynamics dynamics = {};
  std::string strategy;  // the plugin that decides how the equilibrium is found
  Values strategy_parameters;
  double work = 0;     // budget of the search, in the unit of framework/balance/work.hpp
  std::string solver;  // the plugin that solves for equilibria, or for steps in time
  Values solver_parameters;
  // Parameters that the scene sets, by component, such as "newton/newton".
  std::map<std::string, Values> given;
  Limits limits;
  TangentChoice tangent = TangentChoice::exact;
};

/// A row of the bill of materials of a gear; NaN marks a number that does not apply or is not given.
struct BillItem {
  std::string kind;          // netting, rope, piece, body
  std::string name;          // name of the item in the plan
  std::string part_name;     // name in the catalogue; empty if the plan has numbers instead
  double number = 1;         // number of such items in the whole gear
  double length = 0;         // unstretched length of one rope [m]
  double diameter = 0;       // diameter of a twine, a rope or a piece [m]
  double breaking_load = 0;  // breaking load of a rope, or of the twines of a bar [N]
  double mass = 0;           // mass of a piece or a body in air [kg]
  double area = 0;           // projected area of a body [m2]
};

/// A panel of a net plan, as net makers order and cut it.
struct NettingSheet {
  std::string name;
  double number = 1;                   // such panels in the whole gear
  double mesh = 0;                     // stretched mesh size, two bars [m]
  std::string twine;                   // name in the catalogue; empty if the plan has numbers instead
  double twines = 1;                   // twines side by side: 2 in double netting
  std::string laid;                    // diamond, square, t90
  double fore = 0, aft = 0, deep = 0;  // meshes along the whole edges; from fore to aft, over all pieces
  double pieces = 1;                   // pieces sewn mesh to mesh in a row
  // Cuttings from fore to aft, with the meshes that each goes aft: "1N2B in 40, AN 10". A panel in the middle
  // has the outer cuttings on both sides and no inner cuttings.
  std::string outer, inner;
};

/// The place of a panel on the drawing of its plan, in metres of stretched netting, with y aft. The point
/// with the panel coordinates (U, V) [meshes] is at (x + U x_across + V x_deep, y + U y_across + V y_deep).
struct SheetPlace {
  double x = 0, y = 0, x_across = 0, y_across = 0, x_deep = 0, y_deep = 0;
};

/// The parts of a scene that come from a net plan, for reports that use the names of the plan. Indices of
/// parts refer to Scene::parts.
struct GearInScene {
  int times = 1;  // 2 if half a gear is modelled: sums over parts are doubled
  std::vector<std::uint32_t> panels, ropes, pieces;
  // Nodes of the scene, by names such as "headrope.end", "top-wing.fore-outer".
  std::map<std::string, std::uint32_t> points;
  std::size_t nodes = 0;  // requested number of nodes
  double size = 0;        // requested side of triangles [m]; 0: the number of nodes is requested instead
  std::string headline, footrope;  // names of the ropes with these roles; empty: none
  std::set<std::uint32_t> across;  // ropes that run from port over the middle to starboard
  std::map<std::string, std::vector<std::uint32_t>> roles;  // ropes by other roles, such as "bridle"
  /// Pairs of bodies by their name in the plan, as indices of parts. In half a gear, only the starboard body
  /// exists.
  std::map<std::string, std::vector<std::uint32_t>> pairs;
  double ship_speed = 0;       // speed over the ground [m/s]; 0 without a ship
  double ship_efficiency = 0;  // towing power over the heating power of the fuel; 0: unknown
  std::vector<BillItem> bill;
  std::vector<NettingSheet> netting;
  std::map<std::string, SheetPlace> sheet;  // places of panels by their name
  std::shared_ptr<gears::Division> division;
};

/// The strength of a part, from the net plan or the catalogue.
struct Strength {
  double breaking_load = 0;  // breaking load of a rope, or of the twines of a bar [N]; NaN: not known
  std::string material;      // name in the catalogue; empty if the scene gives the load
};

/// Names and outline of a rigid body of Scene::bodies.
struct BodyInScene {
  std::uint32_t part = 0;                      // index of the part in Scene::parts
  double side = 1;                             // 1 to starboard, -1 to port
  std::vector<std::string> points;             // names, in the order of RigidBody::points
  std::vector<std::array<double, 3>> outline;  // corners in body axes, for pictures [m]
};

/// A scene, read from its file and checked.
struct LoadedScene {
  Scene scene;
  std::vector<PartGeometry> parts;  // geometries in the order of scene.parts
  std::vector<BodyInScene> bodies;  // bodies in the order of scene.bodies
  std::vector<Hold> holds;
  std::vector<ResultRequest> results;
  Analysis analysis;
  std::vector<formats::SourceFile> files;
  std::optional<GearInScene> gear;            // nullopt: the scene has no net plan
  std::map<std::string, Strength> strengths;  // strengths by part; parts of unknown strength are left out
  mutable formats::NameIndex index_of_parts = {};  // makes place_of() fast

  /// The place of a part in the file, for messages; line 0 if there is no such part.
  formats::Place place_of(const std::string& part) const {
    const auto at = index_of_parts.find(part, parts, [](const PartGeometry& p) { return p.name; });
    return at ? parts[*at].place : formats::Place{0, 0, 0};
  }
};

}  // namespace netloft::scenes
