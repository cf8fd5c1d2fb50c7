// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <vector>

namespace netloft::runs {

/// Moves the nodes of panel `to` to their places on the netting in the shape of panel `from`. The panels
/// divide the same netting into different triangles; a place on it is a pair of twine coordinates (u, v). `x`
/// holds the node positions of the scene of `from` [m]. The new position is interpolated in the triangle of
/// `from` that contains the place, or extrapolated from the nearest triangle. `positions` are those of the
/// scene of `to`.
void carry_panel(const Part& from, const std::vector<double>& x, const Part& to,
                 std::vector<double>& positions);

/// Does the same for a rope, whose places are fractions of its unstretched length.
void carry_rope(const Part& from, const std::vector<double>& x, const Part& to,
                std::vector<double>& positions);

}  // namespace netloft::runs
