// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Positions of the nodes of a scene by a result [m], 3 per node: an initial guess. Parts with one name are
/// the same. A node takes the position of the node with its number; on a panel or a rope that is divided
/// differently, that of its place on the netting or along the rope. If the result is half a gear and the
/// scene the whole one, both parts of a pair take the positions of the starboard part, and parts in the
/// middle are continued by their mirror image. Nodes of parts that the result lacks keep their initial
/// positions. Throws FileError if it has none of the parts.
std::vector<double> positions_from(const StoredShape& stored, const scenes::LoadedScene& loaded);

}  // namespace netloft::results
