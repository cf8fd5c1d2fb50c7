// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <vector>

namespace netloft::runs {

/// Brings the nodes of a panel of triangles to where the same place of the netting is on another division of
/// it, `from` with positions `x` [m]: within the triangle there that has the twine coordinates of the node,
/// or beyond the one that is nearest to having them. `positions` are of the scene that `to` belongs to.
void carry_panel(const Part& from, const std::vector<double>& x, const Part& to,
                 std::vector<double>& positions);

/// The same of a rope in bars, by the share of its unstretched length.
void carry_rope(const Part& from, const std::vector<double>& x, const Part& to,
                std::vector<double>& positions);

}  // namespace netloft::runs
