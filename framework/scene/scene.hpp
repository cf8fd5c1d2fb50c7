// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/element_data.hpp"
#include "framework/scene/course.hpp"
#include "framework/scene/standard_gravity.hpp"
#include "framework/scene/water_field.hpp"
#include "framework/scene/winch.hpp"

#include <netloft/interpolation.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace netloft {

/// The water in which the gear is towed. The z axis of the world frame points up; z = 0 at the surface.
struct SceneWater {
  double density = 1025;              // [kg/m3]
  double gravity = kStandardGravity;  // [m/s2]
  double viscosity = 1.19e-6;         // kinematic [m2/s]
};

/// Velocity of the water over depth and time, linear between samples and constant beyond them.
///   c(z, t) = profile(z) factor(t) + drift(t) + tow                                               (1)
/// Without samples, the profile and the drift are zero and the factor is one: still water. A towed gear does
/// not move in the scene; instead, the water, which is at rest relative to the ground, moves past the gear
/// with the velocity `tow`.
struct Current {
  struct Sample {
    double z;                        // [m]
    std::array<double, 3> velocity;  // [m/s]
  };
  struct Factor {
    double t;      // [s]
    double value;  // [1]
  };
  struct Drift {
    double t;                        // [s]
    std::array<double, 3> velocity;  // [m/s]
  };
  std::vector<Sample> samples;       // the profile, increasing in z
  std::vector<Factor> factors = {};  // samples in increasing order of t
  std::vector<Drift> drifts = {};    // samples in increasing order of t
  std::array<double, 3> tow = {};    // [m/s]

  bool flows() const;
  /// Whether the current is the same at all heights.
  bool is_uniform() const;
  /// Velocity at height z and its derivative with respect to z.
  void at(double z, std::array<double, 3>& velocity, std::array<double, 3>& dz, double t = 0) const;
  /// Displacement of the water since time zero [m]. Only velocities that are the same at all heights count:
  /// `tow`, `drifts`, and the profile if it is uniform.
  std::array<double, 3> carried(double t) const;
};

/// The sea bed: z_b = −depth + slope_x x + slope_y y, plus a relief if there is one.
struct SeaBed {
  bool is_there = false;
  double depth = 0;                 // [m]
  double slope_x = 0, slope_y = 0;  // slopes dz_b/dx, dz_b/dy
  Surface relief = {};              // height above that plane over x and y [m]; constant beyond its edges

  /// Height z_b of the bed at (x, y), its two first and its three second derivatives (xx, xy, yy).
  std::array<double, 6> at(double x, double y) const;
};

/// A law chosen for a slot of a part: "hydro/morison" and its parameters.
struct LawChoice {
  std::string type;
  Values parameters;
  bool operator==(const LawChoice&) const = default;
};

/// A named part of a gear: elements of one type on nodes of the scene.
struct Part {
  std::string name;                  // name of the part, such as "net"
  std::string type;                  // type of its elements, such as "priour/triangle"
  Values parameters;                 // values by name of the parameter
  std::vector<std::uint32_t> nodes;  // scene nodes of the elements, element by element
  ElementData data;
  std::map<std::string, LawChoice> laws = {};  // laws by name of the slot; absent: the slot's default
  bool companion = false;      // made for pairs of neighbouring elements of the preceding part, which has the
                               // same name
  double viscosity_ratio = 1;  // effective viscosity over the water's viscosity, in models of gears
  std::optional<std::uint32_t> flow = {};  // index of the part that is a flow (ext/flow.h) and changes the
                                           // water here; nullopt: none does
  std::vector<double> reach = {};          // fraction of the flow's change of the water at each element
};

/// The part for which a node was first created, and the number of the node in that part.
struct NodeLabel {
  std::uint32_t part = 0, id = 0;
};

/// The given motion of held nodes: their displacement from the start, in the world frame.
struct Guide {
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint8_t> axes;  // per node: the axes that this guide moves
  Course course;
};

enum Axis : std::uint8_t { kAxisX = 1, kAxisY = 2, kAxisZ = 4, kAllAxes = 7 };

/// A rigid body: its origin is a node of the scene, and it carries other nodes. Its rotation vector
/// (netloft/rotation.hpp) adds three unknowns, which belong to no node of the scene.
struct RigidBody {
  struct Point {
    std::uint32_t node;
    std::array<double, 3> r;  // position in the body's own axes [m]
  };
  std::string name;
  std::uint32_t origin = 0;
  // Rotation vector at the start, from the axes of the body to the axes of the world [rad].
  std::array<double, 3> rotation = {};
  std::uint8_t held_rotation = 0;  // components of the rotation vector that cannot change
  std::vector<Point> points;
  std::uint32_t rotation_node = 0;  // number of the node for the rotation, set by the assembler
  /// The arm [m]: rotations times the arm are lengths, moments divided by it are forces. It is the largest
  /// distance between the origin and a point of the body, or 1 m if the body has no other point.
  double arm() const;
};

/// A number of the scene that is found together with the equilibrium, such as the length of a rope. It is the
/// sum of a datum over the elements of a part. The datum is multiplied by a factor such that a held node has
/// a required reaction.
struct Setting {
  std::string name;        // "length of warp", for sentences
  std::string part;        // name of the part and of its companions (on pairs of its elements)
  std::string datum;       // name of the data that are multiplied, "rest_length"
  std::string unit;        // unit of the sum of the data over the elements of the part
  std::uint32_t node = 0;  // node of the scene, held along all axes
  double wanted = 0;       // magnitude of the reaction at this node [N]
  double factor = 1;       // factor by which the data have been multiplied since the scene was read
};

/// The model: parts of a gear on nodes in water, with holds, guides and bodies. It is plain data, which the
/// reader of a file fills in.
struct Scene {
  std::string name;
  SceneWater water;
  Current current;
  std::shared_ptr<const WaterField> waves = {};  // waves in a motion; nullptr: none
  std::array<double, 3> ground = {};             // velocity at which the ground passes the gear [m/s]
  SeaBed bed = {};
  std::vector<double> positions;   // initial positions, 3 per node [m]
  std::vector<std::uint8_t> held;  // per node: the axes along which the node cannot move
  /// Axes of nodes that are held along axes other than x, y and z: the columns of a rotation matrix, stored
  /// row by row. For these nodes, the bits of `held` refer to these axes.
  std::map<std::uint32_t, std::array<double, 9>> frames;
  std::vector<RigidBody> bodies;  // bodies; their points are `carried`
  std::vector<bool> carried;      // per node: whether a body carries it; empty if there are no bodies
  std::vector<Guide> guides;      // motions of held nodes in time
  std::vector<NodeLabel> labels;  // label of each node
  std::vector<Part> parts;
  std::vector<Setting> settings = {};
  std::vector<Winch> winches = {};

  /// Whether a node cannot move: it is held along all axes and belongs to no body.
  bool stands_still(std::uint32_t node) const {
    return held[node] == kAllAxes && (carried.empty() || !carried[node]);
  }
  /// Adds a body, which carries its points from then on.
  void add_body(RigidBody body);
  /// Index of the body with this origin, if there is one.
  std::optional<std::size_t> body_at(std::uint32_t origin) const;

  /// Times at which the velocity or acceleration of a guide or of the current jumps, increasing [s].
  std::vector<double> corners_in_time() const;

  std::size_t node_count() const { return positions.size() / 3; }
  std::string node_name(std::uint32_t node) const {
    return parts[labels[node].part].name + " node " + std::to_string(labels[node].id);
  }
};

/// An error in a part of a scene, for the author of the scene to correct.
struct SceneFault {
  std::string part;  // empty: the scene as a whole
  std::string message;
};

struct SceneError : std::runtime_error {
  explicit SceneError(std::vector<SceneFault> all)
      : std::runtime_error(all.empty() ? "" : all.front().message), faults(std::move(all)) {}
  std::vector<SceneFault> faults;
};

/// Finds connected pieces of a gear that could drift away along some axis, because none of their nodes is
/// held along it. Returns a fault for each piece.
std::vector<SceneFault> find_loose_parts(const Scene& scene, const std::vector<int>& nodes_per_element);

}  // namespace netloft
