// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"

namespace netloft::runs {

/// Adds the stiffness-proportional part of Rayleigh damping, C = β K, to all elements that have an axial
/// stiffness EA and a damping η of their stretch (tension per strain rate). Parameters are recognised by
/// their roles:
///   η = β EA                                                                               (1)
/// unless the scene gives η. The damping acts along the stretch only, so that rigid motions are not damped,
/// as they would be by β K, because K contains the tension. β [s]
void damp_stretch(Scene& scene, Registry& registry, double beta);

}  // namespace netloft::runs
