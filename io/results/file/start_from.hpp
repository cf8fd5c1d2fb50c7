// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Positions of the nodes of a scene, taken from a result as an initial guess [m], 3 per node. Parts
/// correspond if they have the same name. A node takes the position of the node with its number; on a panel
/// or a rope with another division, it takes the position of its place on the netting or along the rope. If
/// the result is a half gear and the scene the whole one, both parts of a pair take the positions of the
/// starboard part, and parts in the middle are completed by their mirror image. Nodes of parts that the
/// result lacks keep their initial positions. Throws FileError if the result has none of the parts.
std::vector<double> positions_from(const StoredShape& stored, const scenes::LoadedScene& loaded);

}  // namespace netloft::results
