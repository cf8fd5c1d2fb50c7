// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/course.hpp"
#include "io/gears/plan/net_plan.hpp"

namespace netloft::scenes {

/// The displacement over time of a block, at which a warp begins. `from_the_middle` is its distance to
/// starboard from the middle of the ship, or of the pair of ships [m]. The displacement is measured in a
/// frame that moves steadily with the initial velocity of the ship: towards -x with the speed V₀. V is the
/// speed over the ground, ψ the heading, positive to starboard:
///   way = ∫ (V₀ − V cos ψ, V sin ψ, 0) dt + from_the_middle (sin ψ, cos ψ − 1, 0)          (1)
/// V and ψ are linear between the times at which the plan gives them. If there are two ships, each has its
/// own path, and one block in its middle.
Course course_of_block(const gears::Ship& ship, double from_the_middle);

}  // namespace netloft::scenes
