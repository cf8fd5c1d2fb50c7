// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scene/loaded_scene.hpp"

#include <cstdint>

namespace netloft::io {

/// One division of a scene into cells; of a scene with a net plan, into nodes of the gear.
struct MeshLevel {
  std::int64_t cells = 0;  // of the leading part, across it or along it; or nodes of the gear, about
  std::vector<std::string> overrides;
};

/// How finely a scene is divided, as meshes are compared by.
struct MeshCount {
  std::int64_t count = 0;  // cells of the leading part, or nodes of a gear
  double width = 0;        // of the mesh, in a unit of its own: 1/cells, 1/√nodes
  std::string of;          // "cells of net", "nodes of the gear"
};
MeshCount count_mesh(const LoadedScene& loaded);

/// What `--cells` asks for: "8,16,32", or "net=8,16,32" of one part alone.
struct CellList {
  std::string part;                 // empty: all parts in proportion
  std::vector<std::int64_t> cells;  // rising
};

/// Throws std::invalid_argument with a sentence when the word is not understood.
CellList read_cell_list(const std::string& word);

/// The part whose cells a division is named after: the first panel, else the first rope. Throws
/// std::invalid_argument when nothing in the scene is divided.
const PartGeometry& leading_part(const LoadedScene& loaded);

/// The divisions of a list: the leading part has as many cells as it says, all others in proportion. Throws
/// std::invalid_argument when some part would have no whole number of cells, or a node is named by its
/// number, which is another one on another mesh.
std::vector<MeshLevel> mesh_levels(const LoadedScene& loaded, const CellList& list);

/// Divisions of a gear into about so many nodes each; other parts keep their cells. Throws
/// std::invalid_argument as above, and if the scene has no gear.
std::vector<MeshLevel> gear_levels(const LoadedScene& loaded, const std::vector<std::int64_t>& nodes);

/// Two divisions to set beside the scene's own to learn how good it is: a quarter and a half of its cells
/// where that is possible, which costs little; else half and twice; else only twice as many. Of a gear, a
/// sixteenth and a quarter of its nodes, or a quarter and four times as many. Throws as above.
std::vector<MeshLevel> levels_around(const LoadedScene& loaded);

}  // namespace netloft::io
