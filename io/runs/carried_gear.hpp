// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <vector>

namespace netloft::runs {

/// Gives the nodes of panel `to` the shape of panel `from`. Both panels divide the same piece of netting, but
/// into different triangles. A place on this netting is a pair of twine coordinates (u, v). `x` contains the
/// node positions of the scene of `from` [m], `positions` those of the scene of `to`, which are changed. Each
/// node of `to` gets the position of its place in `from`: interpolated in the triangle that contains the
/// place, or extrapolated from the nearest triangle.
void carry_panel(const Part& from, const std::vector<double>& x, const Part& to,
                 std::vector<double>& positions);

/// Like carry_panel(), but for ropes; a place is a fraction of the unstretched length.
void carry_rope(const Part& from, const std::vector<double>& x, const Part& to,
                std::vector<double>& positions);

}  // namespace netloft::runs
