// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <cstdint>

namespace netloft::studies {

/// A mesh: the numbers of cells of the parts of a scene, or a number of nodes for the gear of a net plan.
struct MeshLevel {
  // Number of cells of the leading part (leading_part), or the approximate number of nodes of the gear.
  std::int64_t cells = 0;
  std::vector<formats::Change> changes;
};

/// The fineness of a mesh, for the comparison of meshes.
struct MeshSize {
  std::int64_t count = 0;  // number of cells of the leading part, or of nodes of a gear
  double width = 0;        // mesh width in arbitrary units: 1/cells, 1/√nodes
  std::string of;          // what is counted: "cells of net", "nodes of the gear"
  bool is_similar = true;  // false for the mesh of a gear, which is triangulated anew for each fineness
};
MeshSize count_mesh(const scenes::LoadedScene& loaded);

/// The argument of `--cells`: "8,16,32", or "net=8,16,32" to divide only the part `net`.
struct CellList {
  std::string part;                 // name of the part; empty: all parts, in proportion
  std::vector<std::int64_t> cells;  // numbers of cells, increasing
};

/// Reads the argument of `--cells`. Throws std::invalid_argument with a sentence if it is not a list of
/// cells.
CellList read_cell_list(const std::string& text);

/// The part whose number of cells is the name of a mesh: the first panel or, if there is no panel, the first
/// rope. Throws std::invalid_argument if no part is divided into cells.
const scenes::PartGeometry& leading_part(const scenes::LoadedScene& loaded);

/// The meshes of a list. The leading part gets the listed number of cells, and all other parts are divided in
/// proportion. Throws std::invalid_argument if the number of cells of a part would not be whole, or if the
/// scene names a node by its number, which another node has on another mesh.
std::vector<MeshLevel> mesh_levels(const scenes::LoadedScene& loaded, const CellList& list);

/// Meshes of a gear with approximately these numbers of nodes; parts outside the gear keep their cells.
/// Throws std::invalid_argument like mesh_levels(), and if the scene has no gear.
std::vector<MeshLevel> gear_levels(const scenes::LoadedScene& loaded, const std::vector<std::int64_t>& nodes);

/// The meshes that are compared with the mesh of the scene to estimate its mesh error. The first choice is
/// two meshes with a quarter and with half of its cells, which cost little; the second choice is two meshes
/// with half and with twice its cells; the last choice is one mesh with twice its cells. For a gear: half and
/// twice its nodes, or twice and four times its nodes if half would be too few for a useful solve. Throws
/// std::invalid_argument like mesh_levels().
std::vector<MeshLevel> levels_around(const scenes::LoadedScene& loaded);

}  // namespace netloft::studies
