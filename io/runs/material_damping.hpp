// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/scenes/reading/analysis.hpp"

#include <string>

namespace netloft::runs {

/// Decides whether the loss factors of materials are used. They are used in a motion, and in a static
/// analysis if the motion after a small disturbance decides whether the equilibrium is stable. They are not
/// used if the scene says `material_damping` = false, if a motion has `stiffness_damping` instead, or if the
/// integrator is stable for short steps only, because the damping of stiff twines would make these steps far
/// too short. Removes unused loss factors from the scene, and loss factors of parts that have another
/// damping. Returns a sentence about the loss factors; an empty text if no part has a loss factor.
std::string choose_material_damping(Scene& scene, const scenes::Analysis& analysis, Registry& registry);

/// Removes the loss factors from a static scene whose forces all have a potential: its stability follows from
/// the tangent, without a motion.
void take_out_losses(Scene& scene, Registry& registry);

}  // namespace netloft::runs
