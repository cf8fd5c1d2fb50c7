// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/scenes/reading/analysis.hpp"

#include <string>

namespace netloft::runs {

/// Whether the loss factors of materials count in an analysis: in motions, and in how a small disturbance of
/// what is static moves, unless `material_damping` is off or the steps of the scheme are bounded by
/// stability, which the damping of stiff twines would make too short by far. Where they do not count, or a
/// part states a damping of its own, they are taken out of the scene. Returns a sentence for the plan; empty:
/// no part has one.
std::string choose_material_damping(Scene& scene, const scenes::Analysis& analysis, Registry& registry);

/// Takes them out of a static scene whose forces have an energy: no motion is asked for there.
void take_out_losses(Scene& scene, Registry& registry);

}  // namespace netloft::runs
