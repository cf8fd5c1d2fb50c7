// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/scenes/reading/analysis.hpp"

#include <string>

namespace netloft::runs {

/// Decides whether the loss factors of materials count in an analysis. They do in motions, and in the motion
/// of a small disturbance of an equilibrium, unless `material_damping` is off or the steps of the integrator
/// are bounded by stability, because the damping of stiff twines would make them far too short. Loss factors
/// that do not count, and those of parts with a damping of their own, are removed from the scene. Returns a
/// sentence for the plan, or nothing if no part has a loss factor.
std::string choose_material_damping(Scene& scene, const scenes::Analysis& analysis, Registry& registry);

/// Removes them from a static scene whose forces have an energy, since its stability needs no motion.
void take_out_losses(Scene& scene, Registry& registry);

}  // namespace netloft::runs
