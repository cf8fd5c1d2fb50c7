// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"

#include <functional>

namespace netloft::scenes {

/// Side and initial guess of a body of a net plan, which are not in its table.
struct BodyOfPlan {
  double side = 1;  // 1: starboard; -1: port, with `at` mirrored
  /// The initial position of the body if its table has none. `lowest`: lowest z of its points and its
  /// outline, from its origin [m].
  std::function<std::array<double, 3>(double lowest)> guess;
};

/// Reads a rigid body: the position of its origin `at`, its named `points`, its initial rotation `turned`,
/// and its `side`. Own nodes are the origin and the points; sets are `origin` and the names of the points.
/// Data: side, 1 or -1; arm, zero [m].
Geometry read_body(formats::TableReader& table, const BodyOfPlan* plan = nullptr);

/// Makes the bodies of a scene whose nodes are numbered; reports faults at their places.
void add_bodies(Draft& draft, formats::Diagnostics& diagnostics);

/// Moves the carried points to their positions on the bodies, after a sketch or a hold has placed the
/// origins.
void place_points(Scene& scene);

/// The body that carries a node; null if none does.
const RigidBody* body_that_carries(const Scene& scene, std::uint32_t node);

}  // namespace netloft::scenes
