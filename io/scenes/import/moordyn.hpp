// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/import/bar_table.hpp"

namespace netloft::scenes {

/// A mooring of MoorDyn as nodes and bars, with the features that the import changes or leaves out.
struct MooringFile {
  struct Finding {
    formats::Place place;
    bool is_left_out = false;  // whether results differ without the feature
    std::string text;
  };
  BarTable table;
  std::vector<Finding> findings;
};

/// Reads an input file of MoorDyn, version 1 or 2 (https://moordyn.readthedocs.io, "Input Files";
/// BSD-3-Clause): points, and lines with one bar per segment. Errors are reported at their line and column;
/// `file` is the index of `text` among the sources of `diagnostics`. After an error the result contains
/// whatever could be read.
MooringFile read_moordyn(const std::string& text, int file, formats::Diagnostics& diagnostics);

}  // namespace netloft::scenes
