// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace netloft::scenes {

/// Orders the corners of triangles on which a pressure acts so that they are counter-clockwise seen from
/// outside, however the panels were drawn. The inside of a panel is the side on which the centre of all
/// triangles lies; a panel whose plane contains this centre stays as it is. `begins`: index in `rider.nodes`
/// at which the corners of each panel begin. `positions`: initial positions of the nodes of the scene [m].
void turn_outward(const std::vector<std::size_t>& begins, const std::vector<double>& positions, Part& rider);

}  // namespace netloft::scenes
