// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/file/stored_result.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Where a result has the nodes of a scene [m], 3 per node: an initial guess. Parts are the same if they have
/// one name. Nodes with the same numbers are where the result has them; of a panel or a rope that is divided
/// otherwise, where the result has that place of the netting, or that share of the rope. Of half a gear, the
/// part to starboard stands for a pair, and what is in the middle is continued by its mirror image, for the
/// whole gear. Nodes of parts that the result has not stay where they start. Throws FileError if it has none
/// of the parts.
std::vector<double> positions_from(const StoredResult& result, const scenes::LoadedScene& loaded);

}  // namespace netloft::results
