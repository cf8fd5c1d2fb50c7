// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "tests/validation/real_gears/neutral_case.hpp"

namespace netloft::real_gears {

/// How a gear becomes a scene.
struct Modelling {
  /// true, as in FEMNET: above the surface there is no drag, and ropes have no buoyancy. false, as in
  /// Netloft: water is everywhere.
  bool surface = true;
  /// Ropes bend by rope/bending, which has a potential, instead of FEMNET's law, which has none.
  bool shipped_bending = false;
};

/// Makes the scene from the flat drawing: netting is priour/triangle, ropes are rope/bar, and the plugin
/// femnet adds forces that these lack. Nodes on a plane of symmetry bear half of their loads.
Scene make_scene(const NeutralCase& gear, const Modelling& modelling = {});

/// Moves the nodes of the scene to these positions.
void place_nodes(Scene& scene, const std::vector<Vector>& positions);

}  // namespace netloft::real_gears
