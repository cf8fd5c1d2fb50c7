// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/time_march.hpp"
#include "io/hdf5/read.hpp"
#include "io/hdf5/tree.hpp"

namespace netloft::io {

/// What a march goes on from, under /netloft/checkpoint. `scene` tells one scene from another: going on with
/// another one is refused.
void write_checkpoint(Tree& tree, const MarchState& state, const std::string& scene);

/// Throws FileError if there is none, or it is of another scene.
MarchState read_checkpoint(const Reader& reader, const std::string& scene);

}  // namespace netloft::io
