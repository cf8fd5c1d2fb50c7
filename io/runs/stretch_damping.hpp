// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"

namespace netloft::runs {

/// The part of Rayleigh's damping that is proportional to stiffness, C = β K: of everything that has an axial
/// stiffness EA and a damping η of its stretch (tension per strain rate), by the roles of its parameters,
///   η = β EA                                                                               (1)
/// where the scene does not give η. It acts along the stretch alone, so that what moves as a whole is not
/// damped, as it would be by K itself, which holds the tension as well. β [s]
void damp_stretch(Scene& scene, Registry& registry, double beta);

}  // namespace netloft::runs
