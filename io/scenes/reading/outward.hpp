// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace netloft::scenes {

/// A panel whose triangles a rider (a part on other parts) copies. `begin` is the index among the rider's
/// nodes of the first corner of the panel. `is_outward`: whether the corners of each triangle are known to be
/// counter-clockwise seen from outside, as in panels of a net plan.
struct PanelBelow {
  std::size_t begin = 0;
  bool is_outward = false;
};

/// The values of the datum `outward`, 1 or -1 for each triangle, and the number of panels whose inside is
/// unknown.
struct Outward {
  std::vector<double> of_triangles;
  std::size_t unknown = 0;
};

/// Finds for each triangle of `rider` whether its corners are counter-clockwise seen from outside (1) or not
/// (-1). The inside of a panel is the side on which the centre of all triangles lies, no matter how the panel
/// was drawn. If this centre lies in the plane of a panel, the inside of the panel is unknown, and its
/// triangles get 1. `positions` are the initial positions of the nodes of the scene [m].
Outward find_outward(const std::vector<PanelBelow>& panels, const std::vector<double>& positions,
                     const Part& rider);

}  // namespace netloft::scenes
