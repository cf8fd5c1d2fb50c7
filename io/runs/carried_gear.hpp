// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <vector>

namespace netloft::runs {

/// Moves the nodes of a panel of triangles, `to`, to the positions that the same places of the netting have
/// on another division, `from` with positions `x` [m]. A place lies within the triangle that has the twine
/// coordinates of the node, or is extrapolated from the nearest triangle. `positions` are of the scene of
/// `to`.
void carry_panel(const Part& from, const std::vector<double>& x, const Part& to,
                 std::vector<double>& positions);

/// The same for a rope in bars, by the fraction of its unstretched length.
void carry_rope(const Part& from, const std::vector<double>& x, const Part& to,
                std::vector<double>& positions);

}  // namespace netloft::runs
