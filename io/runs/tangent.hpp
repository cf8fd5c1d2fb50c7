// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"

#include <optional>
#include <vector>

namespace netloft::runs {

/// Whether displacements of one scene can be used in the other: the same unknowns, numbered alike.
bool have_same_topology(const PreparedScene& a, const PreparedScene& b);

/// First-order motion of the equilibrium x of `scene` while the scene becomes `near`, whose values differ by
/// a little and whose topology is the same:
///   K(x) dx = −(r_near(x) − r(x))                                                      (1)
/// over all dofs, those of holds included. Nothing if K has no factor, if x cannot be evaluated in one of the
/// scenes, or if the scene leaves quantities open (Scene::settings), which would have to move as well.
std::optional<std::vector<double>> tangent_towards(PreparedScene& scene, PreparedScene& near,
                                                   const std::vector<double>& x, Statistics& spent);

}  // namespace netloft::runs
