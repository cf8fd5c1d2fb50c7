// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <string>
#include <vector>

namespace netloft::results {

/// Sentences for a gear that is where nobody means it to be, which no equation forbids: parts above the
/// surface, where the model has water all the same unless an element knows the surface; parts below the bed;
/// and a gear made to rest on the bed of which nothing, or no footrope, touches it. Warps of a ship, which
/// begin in the air, are left out.
std::vector<std::string> whereabouts_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                              const Response& answer);

}  // namespace netloft::results
