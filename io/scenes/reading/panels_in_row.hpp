// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace netloft::scenes {

/// Corrects the datum to_aft, the meshes from a corner to the aft end, for netting that is cut into several
/// panels one behind another. If the aft edge of a panel is sewn to panels of the same part, its to_aft grows
/// by the meshes behind that edge, averaged over the nodes of the edge. `begins`: index in `rider.nodes` at
/// which the corners of each panel begin.
void count_meshes_through_seams(const std::vector<std::size_t>& begins, Part& rider);

}  // namespace netloft::scenes
