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
  std::string file;    // GEAR
  std::string output;  // -o
  // options for a net plan
  std::vector<std::string> set;  // --set path=value
  bool mesh = false;             // --mesh
  std::size_t nodes = 2000;      // --nodes
  // options for a result
  std::string view = "oblique";  // --view
  std::string field;             // --field
  int state = -1;                // --state; -1: the newest
  std::size_t width = 1000;      // --width
  std::string fit = "netting";   // --fit
  bool dark = false;             // --dark
  bool log = false;              // --log
  bool elements = false;         // --elements
  bool dimensions = false;       // --dimensions
};

struct ImportOptions : CommonOptions {
  std::string format;   // FORMAT
  std::string gear;     // GEAR
  std::string output;   // -o
  std::string mesh;     // --mesh
  std::string folder;   // --check
  bool divide = false;  // --divide
  bool motion = false;  // --motion
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
