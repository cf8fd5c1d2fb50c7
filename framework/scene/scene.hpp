// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameters.hpp"
#include "framework/scene/course.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace netloft {

/// The water a gear hangs in. World frame z up, z = 0 at the surface.
struct SceneWater {
  double density = 1025;       // [kg/m3]
  double gravity = 9.80665;    // [m/s2]
  double viscosity = 1.19e-6;  // kinematic [m2/s]
};

/// Velocity of the water over depth and time: straight lines between samples, constant beyond them.
///   c(z, t) = profile(z) share(t) + drift(t)                                                     (1)
/// Without samples the profile and the drift are zero and the share is one: still water.
struct Current {
  struct Sample {
    double z;                        // [m]
    std::array<double, 3> velocity;  // [m/s]
  };
  struct Share {
    double t;      // [s]
    double value;  // [1]
  };
  struct Drift {
    double t;                        // [s]
    std::array<double, 3> velocity;  // [m/s]
  };
  std::vector<Sample> samples;     // the profile, ascending in z
  std::vector<Share> shares = {};  // ascending in t
  std::vector<Drift> drifts = {};  // ascending in t

  bool flows() const;
  /// Whether it is the same at all heights.
  bool is_uniform() const { return samples.size() <= 1; }
  /// Velocity and its derivative with z at height z.
  void at(double z, std::array<double, 3>& velocity, std::array<double, 3>& dz, double t = 0) const;
};

/// A law chosen for a slot of a part: "hydro/morison" and its parameters.
struct LawChoice {
  std::string type;
  Values parameters;
  bool operator==(const LawChoice&) const = default;
};

/// A named piece of a gear: elements of one type on nodes of the scene.
struct Part {
  std::string name;                  // "net"
  std::string type;                  // "priour/triangle"
  Values parameters;                 // by parameter name
  std::vector<std::uint32_t> nodes;  // scene nodes of the elements, as many each as the stencil has
  std::map<std::string, std::vector<double>> data;  // by datum name: [element][width]
  std::map<std::string, LawChoice> laws = {};       // by slot name; absent: the slot's default
  bool companion = false;                           // rides on the part of the same name before it
};

/// The part a node was first made for, and its number within that part.
struct NodeLabel {
  std::uint32_t part = 0, id = 0;
};

/// Held nodes that are moved: where they are beyond their start, in the world frame.
struct Guide {
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint8_t> axes;  // per node, those that this guide moves
  Course course;
};

enum Axis : std::uint8_t { kAxisX = 1, kAxisY = 2, kAxisZ = 4, kAllAxes = 7 };

/// Nodes carried by a rigid body. Two nodes of the scene stand for its six unknowns: `position`, where its
/// reference point is, and `rotation`, whose three numbers are the rotation vector from the start [rad], zero
/// at first.
struct RigidBody {
  struct Point {
    std::uint32_t node;
    std::array<double, 3> r;  // from the reference point, at the start [m]
  };
  std::string name;
  std::uint32_t position = 0, rotation = 0;
  std::vector<Point> points;
};

/// What is solved: parts on nodes in water, some of them held. Plain data; whoever reads a file makes one.
struct Scene {
  std::string name;
  SceneWater water;
  Current current;
  std::vector<double> positions;   // start, 3 per node [m]
  std::vector<std::uint8_t> held;  // per node, the axes along which it cannot move
  /// Axes of nodes that are held along others than x, y and z: the columns of a rotation, row by row. Bits of
  /// `held` then mean these axes.
  std::map<std::uint32_t, std::array<double, 9>> frames;
  std::vector<RigidBody> bodies;  // their points are `carried`
  std::vector<bool> carried;      // per node; empty if there are no bodies
  std::vector<Guide> guides;      // what moves held nodes in time
  std::vector<NodeLabel> labels;  // per node
  std::vector<Part> parts;

  /// A node that nothing moves: held along all axes, and on no body.
  bool stands_still(std::uint32_t node) const {
    return held[node] == kAllAxes && (carried.empty() || !carried[node]);
  }
  /// Adds a body: its points move with it from now on.
  void add_body(RigidBody body);

  /// Times at which a guide or the current changes its law, ascending [s].
  std::vector<double> corners_in_time() const;

  std::size_t node_count() const { return positions.size() / 3; }
  std::string node_name(std::uint32_t node) const {
    return parts[labels[node].part].name + " node " + std::to_string(labels[node].id);
  }
};

/// Something wrong with a part of a scene that its author can mend.
struct SceneFault {
  std::string part;  // empty: the scene as a whole
  std::string message;
};

struct SceneError : std::runtime_error {
  explicit SceneError(std::vector<SceneFault> all)
      : std::runtime_error(all.empty() ? "" : all.front().message), faults(std::move(all)) {}
  std::vector<SceneFault> faults;
};

/// Parts that could drift away: nothing they are connected to is held along some axis. One fault per loose
/// piece.
std::vector<SceneFault> find_loose_parts(const Scene& scene, const std::vector<int>& nodes_per_element);

}  // namespace netloft
