// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

#include <cstddef>

namespace netloft::program {

struct CatalogueOptions : CommonOptions {
  std::string name;  // name of a part or of a kind of parts; empty: all
};

struct CheckOptions : SceneOptions {};  // `scene` is GEAR, a net plan

struct DrawOptions : CommonOptions {
  std::string file;    // argument GEAR
  std::string output;  // option -o
  // options for a net plan
  std::vector<std::string> set;  // option --set path=value
  bool mesh = false;             // option --mesh
  std::size_t nodes = 2000;      // option --nodes
  // option --width, for a net plan or a result
  std::size_t width = 0;  // option --width; 0: 2200 for a net plan, 1000 for a result
  // options for a result
  std::string view = "oblique";  // option --view
  std::string field;             // option --field
  int state = -1;                // option --state; -1: the newest
  std::string fit = "netting";   // option --fit
  bool dark = false;             // option --dark
  bool log = false;              // option --log
  bool elements = false;         // option --elements
  bool dimensions = false;       // option --dimensions
};

struct ImportOptions : CommonOptions {
  std::string format;   // argument FORMAT
  std::string gear;     // argument GEAR
  std::string output;   // option -o
  std::string mesh;     // option --mesh
  std::string folder;   // option --check
  bool divide = false;  // option --divide
  bool motion = false;  // option --motion
};

/// The kinds of files that `draw` reads.
enum class Drawable { net_plan, result, polars };
Drawable kind_of_drawable(const std::string& file);

int catalogue_command(const CatalogueOptions& options);  // lists parts of the catalogue
int check_command(const CheckOptions& options);          // checks whether a net plan can be sewn
int draw_command(const DrawOptions& options);            // draws a net plan, a result or polars
int draw_result_command(const DrawOptions& options);     // draws a result
int import_command(const ImportOptions& options);        // converts a gear of another program into a scene

}  // namespace netloft::program
