// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::runs {

/// Which numbers of cells are halved. Half of an odd number is rounded up, which changes the shape of cells:
/// parts that are joined, or that need square cells, may then not fit.
enum class Halved { all, even_only };

/// Changes that halve the cells of every rope and panel that has enough of them and no node that something
/// refers to by its number. A gear from a net plan gets a quarter of its nodes, unless something refers to a
/// node of its panels or ropes by number. Empty if nothing can be halved.
std::vector<formats::Change> halved_cells(const scenes::LoadedScene& fine, Halved which);

/// Positions of the nodes of scene `to` [m], 3 per node, interpolated from positions `x` of another division
/// of the same gear. Ropes are straight between nodes, and twines are straight within the triangles of a
/// panel, so that a finer mesh has exactly the strain of the coarser one. Nodes on no rope or panel keep
/// their initial positions. Empty if the scenes are not divisions of the same parts.
std::optional<std::vector<double>> carried_over(const scenes::LoadedScene& from, const std::vector<double>& x,
                                                const scenes::LoadedScene& to);

}  // namespace netloft::runs
