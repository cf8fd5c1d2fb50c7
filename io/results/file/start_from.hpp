// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_shape.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Positions of the nodes of a scene [m], 3 per node, taken from a result as an initial guess. A part of the
/// scene takes positions from the part of the result with the same name. If both parts are divided into
/// elements
/// their place on the netting or along the rope. If the result is half a gear and the scene the whole gear,
/// the starboard part of a pair is used for both sides, and a part in the middle is completed by its mirror
/// image. Nodes of parts that are not in the result keep their initial positions. Throws FileError if none of
/// the parts is in the result.
std::vector<double> positions_from(const StoredShape& stored, const scenes::LoadedScene& loaded);

}  // namespace netloft::results
