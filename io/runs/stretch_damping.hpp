// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"

namespace netloft::runs {

/// Adds the stiffness-proportional part of Rayleigh damping, C = β K, to all elements that have an axial
/// stiffness EA [N] and a damping η [N s] of their stretch (tension per strain rate). If the scene does not
/// give η, it becomes
///   η = β EA                                                                               (1)
/// with β [s]. Parameters are recognised by their roles (flags), not by their names. The damping acts along
/// the stretch only, so that it does not damp rigid motions. β K would damp them, because K contains the
/// tension.
void damp_stretch(Scene& scene, Registry& registry, double beta);

}  // namespace netloft::runs
