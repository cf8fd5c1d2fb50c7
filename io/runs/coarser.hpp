// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::runs {

/// Which numbers of cells are halved. Of an odd one it is the greater half, which leaves cells of another
/// shape: parts that are joined, or that have square cells alone, may not fit then.
enum class Halved { all, even_only };

/// Changes that give every rope and panel half its cells where these are many enough, and where nothing
/// acts on a node of it by its number; and a gear from a net plan a quarter of its nodes, unless something
/// acts so on any of its panels and ropes. Empty when nothing is left to halve.
std::vector<formats::Change> halved_cells(const scenes::LoadedScene& fine, Halved which);

/// Positions of the nodes of one scene [m], 3 per node, read off another division of the same gear where it
/// has been brought to `x`. Between the nodes of a rope lines are straight, within the triangles of a panel
/// the twines are: a finer mesh then has the strain of the coarser one and no other. Nodes that stand on no
/// rope or panel start where they did. Empty when the two are not divisions of the same parts.
std::optional<std::vector<double>> carried_over(const scenes::LoadedScene& from, const std::vector<double>& x,
                                                const scenes::LoadedScene& to);

}  // namespace netloft::runs
