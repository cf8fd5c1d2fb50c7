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
  std::vector<std::string> left_out = {};  // left-out features that change results, one line each
  std::vector<std::string> features = {};  // features of FEMNET that the gear uses
};

/// The files to import, and the options of the scene.
struct ImportRequest {
  std::filesystem::path gear;  // GEAR.don, GEAR.csv
  std::filesystem::path mesh;  // empty: GEAR.mdg beside the gear, if it exists and fits the gear
  std::string own_mesh;        // name of the mesh file that is written and that the scene uses
  bool divides = false;        // whether to divide the gear anew, even if it has a mesh
  bool moves = false;          // whether the scene is a motion, with waves and drums (FEMNET only)
};

/// Reads a gear of FEMNET with its mesh. Errors, warnings and left-out features are added to `diagnostics`,
/// each with its place; after an error, the texts of the result are empty.
ImportedGear import_femnet(const ImportRequest& request, formats::Diagnostics& diagnostics);

/// Reads a table of nodes and bars (TABLE.md). Errors are handled as in import_femnet().
ImportedGear import_table(const ImportRequest& request, formats::Diagnostics& diagnostics);

/// Reads a mooring of MoorDyn. Errors are handled as in import_femnet().
ImportedGear import_moordyn(const ImportRequest& request, formats::Diagnostics& diagnostics);

/// The result of importing all gears of a folder and its subfolders.
struct FolderCheck {
  struct Gear {
    std::string name;
    bool is_read = false;
    std::vector<std::string> lines;  // lines about errors, or about left-out features
    std::vector<std::string> features = {};
  };
  std::vector<Gear> gears;
  std::map<std::string, int> needs;     // number of gears that need each left-out feature
  std::map<std::string, int> features;  // number of gears that use each feature of FEMNET
  int whole = 0;                        // number of gears that use no left-out feature
};
FolderCheck check_folder(const std::filesystem::path& folder, bool moves = false);

}  // namespace netloft::scenes
