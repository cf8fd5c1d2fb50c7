// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace netloft::scenes {

/// A gear of another program as the texts of a scene and a mesh.
struct ImportedGear {
  std::string scene = {}, mesh = {};
  std::size_t nodes = 0, elements = 0;
  std::vector<std::string> left_out = {};  // a line each: results differ from the other program's
  std::vector<std::string> features = {};  // of FEMNET: what the gear needs
};

/// The files to import, and the options of the scene.
struct ImportRequest {
  std::filesystem::path gear;  // GEAR.don, GEAR.csv
  std::filesystem::path mesh;  // empty: GEAR.mdg beside it, if there is one and it is of this gear
  std::string own_mesh;        // name of the mesh in the scene
  bool divides = false;        // the gear is divided here, whatever meshes there are
  bool moves = false;          // of FEMNET: the scene is a motion, with waves and drums
};

/// Reads a gear of FEMNET with its mesh. Errors, warnings and left-out features are added to `diagnostics`
/// with their places; after an error the texts are empty.
ImportedGear import_femnet(const ImportRequest& request, formats::Diagnostics& diagnostics);

/// Reads a table of nodes and bars (TABLE.md), in the same manner.
ImportedGear import_table(const ImportRequest& request, formats::Diagnostics& diagnostics);

/// Reads a mooring of MoorDyn, in the same manner.
ImportedGear import_moordyn(const ImportRequest& request, formats::Diagnostics& diagnostics);

/// Features that the gears of a folder and its subfolders need.
struct FolderCheck {
  struct Gear {
    std::string name;
    bool is_read = false;
    std::vector<std::string> lines;  // errors, or what is left out
    std::vector<std::string> features = {};
  };
  std::vector<Gear> gears;
  std::map<std::string, int> needs;     // of what is left out: in how many gears
  std::map<std::string, int> features;  // of what is needed: in how many gears
  int whole = 0;                        // gears that convert without a line left out
};
FolderCheck check_folder(const std::filesystem::path& folder, bool moves = false);

}  // namespace netloft::scenes
