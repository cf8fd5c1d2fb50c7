// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/time_march.hpp"
#include "io/hdf5/read.hpp"
#include "io/hdf5/tree.hpp"

namespace netloft::io {

/// Writes the state from which a march continues, under /netloft/checkpoint. `scene` identifies the scene;
/// continuing with another one is refused.
void write_checkpoint(Tree& tree, const MarchState& state, const std::string& scene);

/// Throws FileError if there is none, or if it belongs to another scene.
MarchState read_checkpoint(const Reader& reader, const std::string& scene);

}  // namespace netloft::io
