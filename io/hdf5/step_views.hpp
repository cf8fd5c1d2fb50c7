// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "io/hdf5/handle.hpp"

namespace netloft::io {

/// An array of slots in /VTKHDF: `rows` rows of `columns` numbers a state.
struct SlottedArray {
  std::string path;  // "PointData/velocity"
  std::size_t rows, columns;
};

/// Gives every state its own arrays under /steps/<number>/…: virtual datasets, which contain no numbers and
/// refer to the slots of VtkHdf. XDMF readers need them.
void write_step_views(hid_t file, std::size_t states, const std::vector<SlottedArray>& arrays);

/// "/steps/00017/"
std::string step_group(std::size_t step);

}  // namespace netloft::io
