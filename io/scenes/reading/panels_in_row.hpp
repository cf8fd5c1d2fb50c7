// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace netloft::scenes {

/// Counts the meshes from a corner to the aft end of netting that is cut into several panels: the datum
/// to_aft of a panel whose aft edge is sewn to panels of the same part grows by the meshes that they have
/// behind that edge, the mean over its nodes. `begins`: index in `rider.nodes` at which the corners of each
/// panel begin.
void count_meshes_through_seams(const std::vector<std::size_t>& begins, Part& rider);

}  // namespace netloft::scenes
