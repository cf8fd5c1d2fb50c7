// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/static_problem.hpp"
#include "framework/scene/scene.hpp"
#include "framework/scene/scene_plan.hpp"
#include "io/formats/toml/document.hpp"
#include "io/scenes/reading/dynamics.hpp"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace netloft::scenes {

/// A part as its author sees it: its own nodes, numbered from 0, and the names of its edges and corners.
struct PartGeometry {
  std::string name;
  formats::Place place;
  std::vector<std::uint32_t> nodes;  // own number -> scene node
  std::vector<int> cells;            // bars of a rope; cells across, along a panel; empty: not divided
  std::vector<std::array<double, 2>> panel;                // own number -> (U, V) [meshes]; empty off a panel
  std::map<std::string, std::vector<std::uint32_t>> sets;  // "fore" -> own numbers, in order along the edge
  bool is_numbered = false;  // something is held, joined or stands on a node that is called by its number
};

/// A `[[hold]]`, for reactions by name.
struct Hold {
  std::string name;
  std::vector<std::uint32_t> nodes;  // of the scene
  std::vector<std::uint8_t> axes;    // per node, those that count with this hold
};

/// One line of `[results]`: a named scalar, such as the lowest z of the net.
struct ResultRequest {
  enum class Source { position, displacement, reaction, attitude, output };
  std::string name, of, take;
  std::string how;       // min, max, mean, sum, range
  std::string quantity;  // "z", "tension"
  std::string unit, doc;
  Source source = Source::position;
  int axis = 0;                      // of positions, displacements and reactions; 3 is the length; of
                                     // attitudes the angle: heading, heel, trim
  std::uint32_t body = 0;            // of attitudes, in Scene::bodies
  std::vector<std::uint32_t> nodes;  // of the scene
  std::uint32_t part = 0;            // for outputs
};

/// How the scene is to be solved.
struct Analysis {
  AnalysisKind kind = AnalysisKind::statics;
  bool settles = false;  // `solver` is an integrator, which goes through time until all is at rest
  Dynamics dynamics = {};
  std::string strategy;  // the plugin that decides how the equilibrium is found
  Values strategy_parameters;
  double work = 0;     // budget of the strategy, in the units of framework/balance/work.hpp
  std::string solver;  // the plugin that solves stages, or steps in time
  Values solver_parameters;
  std::map<std::string, Values> given;  // what the scene says of components by type, "newton/newton"
  Limits limits;
  TangentChoice tangent = TangentChoice::exact;
};

/// A row of the bill of materials of a gear; NaN marks a number that does not apply or is not given.
struct BillItem {
  std::string kind;          // netting, rope, piece, body
  std::string name;          // in the plan
  std::string part_name;     // in the catalogue; empty: written in the plan
  double number = 1;         // in the whole gear
  double length = 0;         // of one rope, unstretched [m]
  double diameter = 0;       // of a twine, a rope or a piece [m]
  double breaking_load = 0;  // of a rope, or of the twines of a bar [N]
  double mass = 0;           // of a piece or a body, in air [kg]
  double area = 0;           // of a body, projected [m2]
};

/// The place of a panel on the drawing of its plan: the point (U, V) in meshes is at
/// (x + U x_across + V x_deep, y + U y_across + V y_deep), in metres of stretched netting, y aft.
struct SheetPlace {
  double x = 0, y = 0, x_across = 0, y_across = 0, x_deep = 0, y_deep = 0;
};

/// The parts of a scene that come from a net plan, for reports in the plan's names. Parts are numbered as in
/// Scene::parts.
struct GearInScene {
  int times = 1;  // 2: a half was modelled, and what is summed up counts twice
  std::vector<std::uint32_t> panels, ropes, pieces;
  std::map<std::string, std::uint32_t> points;  // "headrope.end", "top-wing.fore-outer": node of the scene
  std::size_t nodes = 0;                        // about as many were asked for,
  double size = 0;                              // or sides of triangles of about this length [m]; 0: by nodes
  std::string headline, footrope;               // ropes by their roles in the plan; empty: none
  std::set<std::uint32_t> across;               // ropes from one side to the other: port, middle, starboard
  std::map<std::string, std::vector<std::uint32_t>> roles;  // ropes of the other roles, such as bridle
  /// Bodies that are there to port and to starboard, by their name in the plan: parts of the scene; of a half
  /// the one to starboard.
  std::map<std::string, std::vector<std::uint32_t>> pairs;
  double ship_speed = 0;       // over the ground [m/s]; 0: there is no ship
  double ship_efficiency = 0;  // towing power over the heat of the fuel; 0: not known
  std::vector<BillItem> bill;
  std::map<std::string, SheetPlace> sheet;  // by panel, as the gear names it
};

/// The strength of a part, from its plan or the catalogue.
struct Strength {
  double breaking_load = 0;  // of a rope, or of the twines of a bar [N]; NaN: not known
  std::string material;      // in the catalogue; empty: written in the scene
};

/// Names and looks of a rigid body of Scene::bodies.
struct BodyInScene {
  std::uint32_t part = 0;                      // of Scene::parts, the one that made it
  double side = 1;                             // 1 to starboard, -1 to port
  std::vector<std::string> points;             // names, as RigidBody::points
  std::vector<std::array<double, 3>> outline;  // corners in its own axes, for pictures [m]
};

/// A scene file, read and checked.
struct LoadedScene {
  Scene scene;
  std::vector<PartGeometry> parts;  // as in scene.parts
  std::vector<BodyInScene> bodies;  // as in scene.bodies
  std::vector<Hold> holds;
  std::vector<ResultRequest> results;
  Analysis analysis;
  std::vector<formats::SourceFile> files;
  std::optional<GearInScene> gear;            // of a scene with a net plan
  std::map<std::string, Strength> strengths;  // by part, where something is known

  /// Place of the part that a fault speaks of, for messages.
  formats::Place place_of(const std::string& part) const {
    for (const auto& p : parts)
      if (p.name == part) return p.place;
    return {0, 0, 0};
  }
};

}  // namespace netloft::scenes
