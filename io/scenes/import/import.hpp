// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace netloft::scenes {

/// A gear of another program, converted into the texts of a scene and a mesh.
struct ImportedGear {
  std::string scene = {}, mesh = {};
  std::size_t nodes = 0, elements = 0;
  std::vector<std::string> left_out = {};  // features left out, one line each; results differ without them
  std::vector<std::string> features = {};  // features of FEMNET that the gear uses
};

/// The files to import, and the options of the scene.
struct ImportRequest {
  std::filesystem::path gear;  // GEAR.don, GEAR.csv
  std::filesystem::path mesh;  // empty: GEAR.mdg beside the gear, if it exists and fits the gear
  std::string own_mesh;        // name of the mesh in the scene
  bool divides = false;        // whether to divide the gear here even if it has a mesh
  bool moves = false;          // FEMNET only: whether the scene is a motion, with waves and drums
};

/// Reads a gear of FEMNET with its mesh. Errors, warnings and left-out features are added to `diagnostics`
/// with their places; after an error the texts are empty.
ImportedGear import_femnet(const ImportRequest& request, formats::Diagnostics& diagnostics);

/// Reads a table of nodes and bars (TABLE.md), in the same manner.
ImportedGear import_table(const ImportRequest& request, formats::Diagnostics& diagnostics);

/// Reads a mooring of MoorDyn, in the same manner.
ImportedGear import_moordyn(const ImportRequest& request, formats::Diagnostics& diagnostics);

/// The result of importing all gears of a folder and its subfolders.
struct FolderCheck {
  struct Gear {
    std::string name;
    bool is_read = false;
    std::vector<std::string> lines;  // errors, or features left out
    std::vector<std::string> features = {};
  };
  std::vector<Gear> gears;
  std::map<std::string, int> needs;     // number of gears by feature that is left out
  std::map<std::string, int> features;  // number of gears by feature that they use
  int whole = 0;                        // number of gears that convert without a left-out feature
};
FolderCheck check_folder(const std::filesystem::path& folder, bool moves = false);

}  // namespace netloft::scenes
