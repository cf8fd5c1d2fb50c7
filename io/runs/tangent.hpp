// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

#include <optional>
#include <vector>

namespace netloft::runs {

/// Whether displacements of scene `a` are valid for scene `b`: both have the same unknowns in the same order.
bool have_same_topology(const PreparedScene& a, const PreparedScene& b);

/// First-order change of the equilibrium x of `scene` when the scene becomes `near`, which has slightly
/// different values and the same topology:
///   K(x) dx = −(r_near(x) − r(x))                                                      (1)
/// r is the residual and K the tangent of `scene`, r_near the residual of `near`; dx includes the held
/// degrees of freedom. nullopt if K cannot be factorised, or if x cannot be evaluated in one of the scenes.
/// nullopt also if the scene leaves quantities to the search (Scene::settings), because these would have to
/// change as well.
std::optional<std::vector<double>> tangent_towards(PreparedScene& scene, PreparedScene& near,
                                                   const std::vector<double>& x, Statistics& spent);

}  // namespace netloft::runs
