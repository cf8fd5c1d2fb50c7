// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// Returns a sentence for every part whose tension exceeds the breaking load in the plan or the catalogue,
/// and for every part with a strain that no rope or twine bears. load_warnings() judges parts in the bill of
/// materials instead.
std::vector<std::string> overload_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                           const Response& answer);

/// A sentence for every part with elements outside their range of validity (NETLOFT_OUTPUT_DOUBT), and for
/// every part that has passed through its mirror image (find_crossings).
std::vector<std::string> doubt_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                        const Response& answer);

}  // namespace netloft::results
