// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <vector>

namespace netloft::runs {

/// Moves the nodes of panel `to` to the positions of the same places of the netting on panel `from`, another
/// division of it into triangles with node positions `x` [m]. The position is interpolated in the triangle
/// that contains the node's twine coordinates, or extrapolated from the nearest triangle. `positions` belong
/// to the scene of `to`.
void carry_panel(const Part& from, const std::vector<double>& x, const Part& to,
                 std::vector<double>& positions);

/// Moves the nodes of a rope of bars likewise; a place is a fraction of the rope's unstretched length.
void carry_rope(const Part& from, const std::vector<double>& x, const Part& to,
                std::vector<double>& positions);

}  // namespace netloft::runs
