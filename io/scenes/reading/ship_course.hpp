// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/course.hpp"
#include "io/gears/plan/net_plan.hpp"

namespace netloft::scenes {

/// The way of a block that is `from_the_middle` of the ship, or of two of them, to starboard [m], as seen by
/// who goes on steadily as the ship did at the start, to -x with the speed V₀. With V its speed over the
/// ground and ψ its heading, to starboard,
///   way = ∫ (V₀ − V cos ψ, V sin ψ, 0) dt + from_the_middle (sin ψ, cos ψ − 1, 0)          (1)
/// V and ψ are straight between the moments of the path. Of two ships each has its own path, and its block in
/// its middle.
Course course_of_block(const gears::Ship& ship, double from_the_middle);

}  // namespace netloft::scenes
