// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <string>
#include <vector>

namespace netloft::results {

/// Returns sentences about implausible positions of the gear that no equation forbids: parts above the
/// surface, where most elements still compute forces as if in water; parts below the bed; and a gear or a
/// footrope that should touch the bottom but does not. Leaves out the warps of a ship, which begin in the
/// air.
std::vector<std::string> whereabouts_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                              const Response& answer);

}  // namespace netloft::results
