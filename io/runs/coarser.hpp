// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::runs {

/// Which parts get half as many cells: all parts, or only parts whose numbers of cells are even. Half of an
/// odd number is rounded up, which changes the shape of the cells. Joined parts, or parts that need square
/// cells, may then no longer fit.
enum class Halved { all, even_only };

/// Returns the changes to the scene file that halve the cells of its ropes and panels, and that give a gear
/// from a net plan a quarter of its nodes. A part keeps its cells if it has too few, or if a hold, a join or
/// a rider (a part on the nodes of other parts) names one of its nodes by number, because this number would
/// then mean another place. A gear with such a part keeps all its nodes. Empty if nothing can be halved.
std::vector<formats::Change> halved_cells(const scenes::LoadedScene& fine, Halved which);

/// Positions of the nodes of scene `to` [m], 3 per node, interpolated from the positions `x` of scene `from`.
/// Both scenes divide the same gear, but into different elements. Ropes are straight between nodes, and
/// twines are straight within the triangles of a panel, so that a finer mesh has exactly the strain of the
/// coarser one. Nodes that are not on a rope or panel keep their initial positions. nullopt if the scenes do
/// not have the same parts.
std::optional<std::vector<double>> carried_over(const scenes::LoadedScene& from, const std::vector<double>& x,
                                                const scenes::LoadedScene& to);

}  // namespace netloft::runs
