// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

namespace netloft::results {

/// A sentence for every part whose tension is beyond what its plan or the catalogue says that it bears, or
/// whose strain is beyond what anything bears.
std::vector<std::string> overload_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                           const Response& answer);

/// A sentence for every part with elements that are used beyond what is known of them (NETLOFT_OUTPUT_DOUBT),
/// and for what has passed through its mirror image (find_crossings).
std::vector<std::string> doubt_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                        const Response& answer);

}  // namespace netloft::results
