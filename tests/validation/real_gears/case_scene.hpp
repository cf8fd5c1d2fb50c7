// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "tests/validation/real_gears/neutral_case.hpp"

namespace netloft::real_gears {

/// How a gear becomes a scene.
struct Modelling {
  /// FEMNET's: what stands out of the water has neither drag nor, of ropes, buoyancy. Otherwise water is
  /// everywhere, as Netloft has it.
  bool surface = true;
  /// Ropes bend by rope/bending, which has an energy, instead of FEMNET's law, which has none.
  bool shipped_bending = false;
};

/// The scene from the flat drawing: netting as priour/triangle, ropes as rope/bar, and of the plugin femnet
/// what these have not. Nodes on a plane of symmetry carry half of what is put on them.
Scene make_scene(const NeutralCase& gear, const Modelling& modelling = {});

/// The same nodes elsewhere.
void place_nodes(Scene& scene, const std::vector<Vector>& positions);

}  // namespace netloft::real_gears
