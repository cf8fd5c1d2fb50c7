// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"

#include <functional>

namespace netloft::scenes {

/// Side and initial guess of a body of a net plan. They are not in the table of the body.
struct BodyOfPlan {
  double side = 1;  // 1: starboard; -1: port, with `at` mirrored
  /// Returns the initial position of the body if its table has none. `lowest`: lowest z of its points and its
  /// outline, from its origin [m].
  std::function<std::array<double, 3>(double lowest)> guess;
};

/// Reads a rigid body: the position of its origin `at`, its named `points`, its initial rotation `turned`,
/// and its `side`. Its nodes are the origin and the points; sets are `origin` and the names of the points.
/// Data of its element: side, 1 or -1; arm, zero [m].
Geometry read_body(formats::TableReader& table, const BodyOfPlan* plan = nullptr);

/// Makes the rigid bodies of a scene, whose nodes must be numbered. Faults are reported at their places.
void add_bodies(Draft& draft, formats::Diagnostics& diagnostics);

/// Moves the points of bodies to their positions on the bodies, once the initial positions and holds have
/// placed the origins.
void place_points(Scene& scene);

/// The body of which a node is a point (not the origin); nullptr if there is none.
const RigidBody* body_that_carries(const Scene& scene, std::uint32_t node);

}  // namespace netloft::scenes
