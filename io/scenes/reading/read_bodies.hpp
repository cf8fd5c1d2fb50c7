// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"

#include <functional>

namespace netloft::scenes {

/// Side and initial guess of a body of a net plan, beside its table.
struct BodyOfPlan {
  double side = 1;  // 1 to starboard, -1 to port, of which `at` is the mirror image
  /// Its initial position, unless its table has one, from the lowest of its points and of its outline.
  std::function<std::array<double, 3>(double lowest)> guess;
};

/// A rigid body: its origin `at`, named `points`, how it is `turned` at the start and to which `side` it
/// spreads. Own nodes are the origin and the points, sets `origin` and their names. Data: side, 1 or -1.
Geometry read_body(formats::TableReader& table, const BodyOfPlan* plan = nullptr);

/// Makes the bodies of a scene whose nodes are numbered. What is wrong with them is said at their places.
void add_bodies(Draft& draft, formats::Diagnostics& diagnostics);

/// Puts carried points where the bodies have them, wherever a sketch or a hold has put their origins.
void place_points(Scene& scene);

/// The body that carries a node; null: none does.
const RigidBody* body_that_carries(const Scene& scene, std::uint32_t node);

}  // namespace netloft::scenes
