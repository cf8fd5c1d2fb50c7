// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/compare/numbers_on_mesh.hpp"

namespace netloft::studies {

/// Whether `figure` is the tension at the end of a rope, or is computed from such tensions. At a free corner
/// of netting, this tension is singular: it has no limit under mesh refinement, and therefore no error. The
/// tension a short distance inside the rope has a limit.
bool is_of_rope_end(const std::string& figure);

/// Returns a sentence such as "ropes/headrope/tension_starboard does not converge with the mesh; 1.2 m from
/// that end, twice the longest bar there, it is 4873 N ± 41 N". Tension and error are those on the mesh with
/// index `asked`.
std::string divergence_text(const std::string& figure, const std::vector<NumbersOnMesh>& meshes,
                            std::size_t asked);

}  // namespace netloft::studies
