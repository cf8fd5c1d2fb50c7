// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scene/loaded_scene.hpp"

#include <cstdint>

namespace netloft::io {

/// One division of a scene into cells.
struct MeshLevel {
  std::int64_t cells = 0;  // of the leading part, across it or along it
  std::vector<std::string> overrides;
};

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

/// Two divisions to set beside the scene's own to learn how good it is: a quarter and a half of its cells
/// where that is possible, which costs little; else half and twice; else only twice as many. Throws as above.
std::vector<MeshLevel> levels_around(const LoadedScene& loaded);

}  // namespace netloft::io
