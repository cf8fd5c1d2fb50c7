// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"

#include <functional>

namespace netloft::scenes {

/// Side and initial guess of a body of a net plan, which the table of the body does not state.
struct BodyOfPlan {
  double side = 1;  // 1: starboard; -1: port, with `at` mirrored
  /// Returns the initial position of the body if its table states none. `lowest` is the lowest z of its
  /// points and its outline, measured from its origin [m].
  std::function<std::array<double, 3>(double lowest)> guess;
};

/// Reads a rigid body: the position of its origin `at`, its named `points`, its initial rotation `turned`,
/// and its `side`. The nodes of the body are the origin and the points; its sets are `origin` and the names
/// of the points. The data of its element are side (1 or -1) and arm, which is zero [m].
Geometry read_body(formats::TableReader& table, const BodyOfPlan* plan = nullptr);

/// Adds a point at `r` in the axes of a body to the geometry of the body.
void add_body_point(Geometry& of, const std::string& name, const std::array<double, 3>& r);

double length_of(const BodyRim& rim);  // [m]
/// Points on a rim at fractions of its length, from the top outwards and round [m].
std::array<double, 3> point_on(const BodyRim& rim, double fraction);

/// Makes the rigid bodies of a scene, whose nodes must be numbered. Faults are reported at their places.
void add_bodies(Draft& draft, formats::Diagnostics& diagnostics);

/// Moves the points of bodies to their positions on the bodies, after initial positions and holds have placed
/// the origins.
void place_points(Scene& scene);

/// The body of which a node is a point (not the origin); nullptr if there is none.
const RigidBody* body_that_carries(const Scene& scene, std::uint32_t node);

}  // namespace netloft::scenes
