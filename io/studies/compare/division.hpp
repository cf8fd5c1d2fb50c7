// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <cstdint>

namespace netloft::studies {

/// One division of a scene into cells, or of a scene with a net plan into nodes of the gear.
struct MeshLevel {
  // cells of the leading part across or along it, or the approximate number of gear nodes
  std::int64_t cells = 0;
  std::vector<formats::Change> changes;
};

/// The fineness of a mesh, by which meshes are compared.
struct MeshSize {
  std::int64_t count = 0;  // cells of the leading part, or nodes of a gear
  double width = 0;        // mesh width in arbitrary units: 1/cells, 1/√nodes
  std::string of;          // the counted items: "cells of net", "nodes of the gear"
  bool is_similar = true;  // whether meshes of other counts are similar: cells are divided evenly, whereas a
                           // gear is triangulated anew
};
MeshSize count_mesh(const scenes::LoadedScene& loaded);

/// The argument of `--cells`: "8,16,32" for all parts, or "net=8,16,32" for one part alone.
struct CellList {
  std::string part;                 // empty: all parts in proportion
  std::vector<std::int64_t> cells;  // increasing
};

/// Throws std::invalid_argument with a sentence if `text` is not a list of cells.
CellList read_cell_list(const std::string& text);

/// The part whose cells name a division: the first panel, else the first rope. Throws std::invalid_argument
/// if the scene has no divided part.
const scenes::PartGeometry& leading_part(const scenes::LoadedScene& loaded);

/// The divisions of a list: the leading part gets the listed number of cells, and all other parts are divided
/// in proportion. Throws std::invalid_argument if the number of cells of a part would not be whole, or if the
/// scene names a node by its number, which means a different node on another mesh.
std::vector<MeshLevel> mesh_levels(const scenes::LoadedScene& loaded, const CellList& list);

/// Divisions of a gear into approximately these numbers of nodes; parts outside the gear keep their cells.
/// Throws std::invalid_argument as above, and if the scene has no gear.
std::vector<MeshLevel> gear_levels(const scenes::LoadedScene& loaded, const std::vector<std::int64_t>& nodes);

/// Two divisions to compare with the scene's own for an estimate of its mesh error. The first choice is a
/// quarter and a half of its cells, which cost little; the second is half and twice the cells; the last is
/// twice the cells alone. For a gear, half and twice its nodes, or twice and four times if half would give
/// too few nodes for a useful solve. Throws as above.
std::vector<MeshLevel> levels_around(const scenes::LoadedScene& loaded);

}  // namespace netloft::studies
