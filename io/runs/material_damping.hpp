// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/scenes/reading/analysis.hpp"

#include <string>

namespace netloft::runs {

/// Decides whether the loss factors of materials count in an analysis. They count in motions, and in the
/// motion after a small disturbance of an equilibrium. Exceptions are `material_damping` = false, and
/// integrators with steps bounded by stability, because the damping of stiff twines would make the steps far
/// too short. Loss factors that do not count, and those of parts with their own damping, are removed from the
/// scene. Returns a sentence for the plan; empty if no part has a loss factor.
std::string choose_material_damping(Scene& scene, const scenes::Analysis& analysis, Registry& registry);

/// Removes the loss factors from a static scene whose forces have an energy, because its stability needs no
/// motion.
void take_out_losses(Scene& scene, Registry& registry);

}  // namespace netloft::runs
