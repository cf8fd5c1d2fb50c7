// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scene/loaded_scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace netloft::io {

/// Overrides that give every rope and panel half its cells, of an odd number the greater half, where these
/// are many enough; empty when nothing is left to halve. Edges of the same number of cells still have one.
std::vector<std::string> halved_cells(const LoadedScene& fine);

/// Positions of the nodes of one scene [m], 3 per node, read off another division of the same gear where it
/// has been brought to `x`. Between the nodes of a rope lines are straight, within the triangles of a panel
/// the twines are: a finer mesh then has the strain of the coarser one and no other. Nodes that stand on no
/// rope or panel start where they did. Empty when the two are not divisions of the same parts.
std::optional<std::vector<double>> carried_over(const LoadedScene& from, const std::vector<double>& x,
                                                const LoadedScene& to);

}  // namespace netloft::io
