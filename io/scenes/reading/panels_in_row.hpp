// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/scenes/reading/outward.hpp"

#include <vector>

namespace netloft::scenes {

/// Corrects the datum to_aft, the number of meshes from a corner to the aft end, for netting that is cut into
/// several panels one behind the other. If the aft edge of a panel is sewn to panels of the same part, its
/// to_aft is increased by the number of meshes behind this edge, averaged over the nodes of the edge.
void count_meshes_through_seams(const std::vector<PanelBelow>& panels, Part& rider);

}  // namespace netloft::scenes
