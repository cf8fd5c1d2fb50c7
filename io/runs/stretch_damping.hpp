// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"

namespace netloft::runs {

/// The stiffness-proportional part of Rayleigh damping, C = β K, for all elements with an axial stiffness EA
/// and a damping η of their stretch (tension per strain rate), found by the roles of their parameters:
///   η = β EA                                                                               (1)
/// unless the scene gives η. The damping acts along the stretch only, so that rigid motions are not damped. K
/// itself would damp them, because it contains the tension. β [s]
void damp_stretch(Scene& scene, Registry& registry, double beta);

}  // namespace netloft::runs
